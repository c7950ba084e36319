// When a render ends: at a finished pass, by number, time or error, whichever comes first.
#include "app/program.h"

namespace sunfleck::engine {
namespace {

using testing_support::operator+;
using testing_support::ProgramTest;
using testing_support::Ran;
using testing_support::read_text;
using testing_support::Words;

class Stops : public ProgramTest {
protected:
    nlohmann::json stats_of(const Words& words) const {
        const Ran ran = render(Words{"-o", "x.exr", "--stats", "x.json", "--quiet"} + words);
        EXPECT_EQ(ran.code, 0) << ran.err;
        return json("x.json");
    }
};

/// The picture after some time is that of as many passes as stats.json says.
TEST_F(Stops, time_ends_at_a_finished_pass) {
    const auto stats = stats_of({"--time", "0.3s"});
    const double seconds = stats["seconds"]["total"];
    EXPECT_GE(seconds, 0.3);
    EXPECT_LT(seconds, 3) << "a second, and as much again where other work goes on";
    const std::string by_time = read_text(path("x.exr"));
    // Of the sampler `uniform`, if there was no time to learn.
    stats_of({"--passes", stats["passes"].dump(), "--photon-sampler",
              stats["settings"]["photon_sampler"]});
    EXPECT_EQ(read_text(path("x.exr")), by_time);
}

/// Of all threads together: sooner than as much time on the wall where two are at work.
TEST_F(Stops, processor_time_ends_at_a_finished_pass) {
    const double one_pass = stats_of({"--passes", "1"})["cpu_seconds"];
    const double limit = one_pass + 0.3;
    const auto stats = stats_of({"--cpu-time", std::to_string(limit)});
    const double seconds = stats["cpu_seconds"];
    EXPECT_GE(seconds, limit - 1e-6);
    EXPECT_LT(seconds, 30);
    const int passes = stats["passes"];
    ASSERT_GT(passes, 1);
    const auto before = stats_of({"--passes", std::to_string(passes)});
    EXPECT_EQ(before["image"]["mean"], stats["image"]["mean"]);
    EXPECT_EQ(stats_of({"--cpu-time", "0.000001"})["passes"], 1);
}

TEST_F(Stops, time_shorter_than_a_pass_gives_one_pass) {
    EXPECT_EQ(stats_of({"--time", "0.000001"})["passes"], 1);
}

TEST_F(Stops, target_error_ends_at_the_first_batch_that_reaches_it) {
    const Words few{"--photons-per-pass", "200", "--indirect", "photons"};
    const auto stats = stats_of(few + Words{"--target-error", "2%", "--passes", "5000"});
    const int passes = stats["passes"];
    EXPECT_LE(stats["image"]["target_error"], 0.02);
    EXPECT_EQ(passes % 16, 0);
    EXPECT_LT(passes, 5000);
    ASSERT_GT(passes, 64) << "later batches have 16 passes: take a smaller error";
    const auto before = stats_of(few + Words{"--passes", std::to_string(passes - 16)});
    EXPECT_GT(before["image"]["target_error"], 0.02);
    EXPECT_EQ(stats_of(few + Words{"--target-error", "0.5"})["passes"], 6);
}

/// The squares of what is so dark are lost below the unit of exact sums: no error would be seen.
TEST_F(Stops, pictures_too_dark_for_error_bars_do_not_end_early) {
    std::string dark = room_text("0.6");
    dark.replace(dark.find("[5 5 5]"), 7, "[5e-8 5e-8 5e-8]");
    testing_support::write_text(path("room.pbrt"), dark);
    const auto stats = stats_of({"--target-error", "10%", "--passes", "80"});
    EXPECT_EQ(stats["passes"], 80);
    EXPECT_NE(stats["warnings"].dump().find("its error bars are not known"), std::string::npos);
}

TEST_F(Stops, passes_come_first) {
    EXPECT_EQ(stats_of({"--passes", "3", "--time", "1h", "--target-error", "0.0001"})["passes"], 3);
    EXPECT_EQ(stats_of({"--pass-range", "40:43", "--time", "2m"})["passes"], 3);
}

}  // namespace
}  // namespace sunfleck::engine
