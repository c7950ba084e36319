// Settings by the names and words of the command line.
#include <gtest/gtest.h>
#include <sunfleck/error.h>
#include <sunfleck/settings.h>

#include <algorithm>
#include <set>

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
    EXPECT_THROW(Settings().set("passes", -1).validate(), Error);
    EXPECT_THROW(Settings().set("mutation-size", "adaptive").validate(), Error);
}

TEST(Settings, are_set_anew_but_where_they_repeat) {
    EXPECT_NO_THROW(Settings().set("passes", -1).set("passes", 3).validate());
    EXPECT_NO_THROW(Settings().set("light-group", "a=1").set("light-group", "b=2").validate());
    EXPECT_THROW(Settings().set("light-group", "a=1").set("light-group", "a=2").validate(), Error);
}

TEST(Settings, know_what_true_means) {
    EXPECT_NO_THROW(Settings().set("energy-compensation", true).validate());
    EXPECT_NO_THROW(Settings().set("splitting", true).set("ris", false).validate());
}

TEST(Settings, are_values) {
    Settings one;
    one.set("passes", -1);
    Settings other = one;
    other.set("passes", 1);
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
