// Settings by the names and words of the command line.
#include <gtest/gtest.h>
#include <sunfleck/error.h>
#include <sunfleck/settings.h>

#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace sunfleck {
namespace {

TEST(Settings, take_names_with_and_without_dashes) {
    for (const char* name : {"photons-per-pass", "--photons-per-pass", "photons_per_pass"})
        EXPECT_NO_THROW(Settings().set(name, 1000).validate()) << name;
    EXPECT_NO_THROW(Settings().set("spp", 4).validate());
}

TEST(Settings, refuse_what_no_flag_is_and_what_no_flag_takes) {
    EXPECT_THROW(Settings().set("photon-per-pass", 1), Error);
    EXPECT_THROW(Settings().set("photon-sampler", "magic"), Error);
    EXPECT_THROW(Settings().set("passes", -1), Error);
    EXPECT_THROW(Settings().set("passes", 2.5), Error);
    EXPECT_THROW(Settings().set("passes", true), Error);
    EXPECT_THROW(Settings().set("time", std::nan("")), Error);
    EXPECT_THROW(Settings().set("target-error", HUGE_VAL), Error);
    for (const char* range : {" 0:5", "+0:5", "-5:5", "0:5 ", "5:5", "0:5:6", "0:"})
        EXPECT_THROW(Settings().set("pass-range", range), Error) << range;
    EXPECT_THROW(Settings().set("mutation-size", "adaptive").validate(), Error);
}

TEST(Settings, name_what_stands_in_place_of_a_flag_of_the_program) {
    for (const char* name : {"nthreads", "--output", "stats", "checkpoint"}) {
        try {
            Settings().set(name, "2");
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("no setting"), std::string::npos);
        }
    }
}

TEST(Settings, take_numbers_of_any_type) {
    EXPECT_NO_THROW(Settings()
                        .set("seed", std::uint64_t{18446744073709551615U})
                        .set("passes", 7U)
                        .set("photons-per-pass", std::size_t{1000})
                        .set("radius-pixels", 1.5F)
                        .set("photon-sampler", std::string_view("uniform"))
                        .validate());
}

TEST(Settings, are_set_anew_but_where_they_repeat) {
    EXPECT_NO_THROW(Settings().set("passes", 4).set("passes", 3).validate());
    EXPECT_NO_THROW(Settings().set("light-group", "a=1").set("light-group", "b=2").validate());
    EXPECT_THROW(Settings().set("light-group", "a=1").set("light-group", "a=2").validate(), Error);
}

TEST(Settings, know_what_true_means) {
    EXPECT_NO_THROW(Settings().set("energy-compensation", true).validate());
    EXPECT_NO_THROW(Settings().set("splitting", true).set("ris", false).validate());
}

TEST(Settings, are_values) {
    Settings one;
    one.set("mutation-size", "adaptive");  // needs another sampler
    Settings other = one;
    other.set("photon-sampler", "paper");
    EXPECT_NO_THROW(other.validate());
    EXPECT_THROW(one.validate(), Error);
}

TEST(Settings, list_each_once_with_help) {
    std::set<std::string> names;
    for (const SettingInfo& info : Settings::list()) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_FALSE(info.help.empty()) << info.name;
        EXPECT_FALSE(info.form.empty()) << info.name;
    }
    EXPECT_TRUE(names.contains("photon-sampler"));
}

}  // namespace
}  // namespace sunfleck
