// The parts of the sampler `adaptive` as a user meets them: each is switched off by a flag, told in
// the statistics, and refused where it says nothing.
#include "app/determinism_support.h"
#include "photon/settings.h"

namespace sunfleck::engine {
namespace {

using testing_support::DeterminismTest;

class AdaptiveParts : public DeterminismTest {
protected:
    void SetUp() override {
        DeterminismTest::SetUp();
        use("cornell", {"--resolution", "8x8", "--photons-per-pass", "500"});
    }
};

TEST_F(AdaptiveParts, are_off_where_the_user_says_so) {
    for (const AdaptivePart& part : kAdaptiveParts) {
        const std::string flag = "--" + std::string(part.name);
        const std::string setting = setting_of(part);
        EXPECT_FALSE(stats("0:1")["settings"].contains(setting)) << flag;
        EXPECT_EQ(stats("0:1", {flag, "off"})["settings"][setting], "off");
        expect_films_apart(flag, setting);
        expect_refused(flag, {{flag, "on"},
                              {flag},
                              {flag, "off", "--photon-sampler", "random"},
                              {flag, "off", "--photon-sampler", "uniform"},
                              {flag, "off", "--mode", "paper"},
                              {flag, "auto", "--integrator", "path"}});
    }
}

TEST_F(AdaptiveParts, of_what_is_off_are_refused) {
    expect_refused("--guide-search", {{"--guide-search", "off", "--emission-guide", "off"}});
}

TEST_F(AdaptiveParts, one_set_in_place_of_splitting) {
    use("cognac-4", {"--resolution", "16x16", "--photons-per-pass", "20000", "--emission-guide",
                     "off", "--indirect", "photons"});
    EXPECT_GE(stats("0:1")["splitting"]["levels"], 3);
    EXPECT_EQ(stats("0:1", {"--splitting", "off"})["splitting"]["levels"], 1);
}

TEST_F(AdaptiveParts, light_that_only_a_search_from_the_view_finds) {
    use("keyhole-8", {"--resolution", "8x8", "--photons-per-pass", "2000"});
    EXPECT_GT(stats("0:1")["photon_paths"]["guided_visible"], 0);
    const auto off = stats("0:1", {"--guide-search", "off"});
    EXPECT_EQ(off["photon_paths"]["guided"], 0);
    EXPECT_EQ(off["photon_paths"]["deposited"], 0);
}

TEST_F(AdaptiveParts, an_objective_is_for_all_passes) {
    expect_films_apart("--objective", "objective", "absolute");
    expect_refused("--objective",
                   {{"--objective", "squared"}, {"--objective", "absolute", "--mode", "paper"}});
}

TEST_F(AdaptiveParts, light_candidates_are_one_for_any_sampler) {
    for (const char* sampler : {"adaptive", "uniform"}) {
        const auto several = stats("0:1", {"--photon-sampler", sampler});
        const auto one = stats("0:1", {"--photon-sampler", sampler, "--ris", "off"});
        EXPECT_FALSE(several["settings"].contains("ris"));
        EXPECT_EQ(one["settings"]["ris"], "off");
        EXPECT_LT(one["rays"]["camera"], several["rays"]["camera"]);
    }
    expect_films_apart("--ris", "ris");
    expect_refused("--ris", {{"--ris", "on"},
                             {"--ris", "off", "--direct", "photons"},
                             {"--ris", "off", "--mode", "paper"},
                             {"--ris", "off", "--integrator", "path"}});
}

}  // namespace
}  // namespace sunfleck::engine
