// Balance as a user meets it: the flag, the statistics, the same bytes however a render is cut.
#include "app/determinism_support.h"

namespace sunfleck {
namespace {

using testing_support::DeterminismTest;
using testing_support::operator+;
using testing_support::Ran;
using testing_support::Words;

class Balance : public DeterminismTest {
protected:
    void SetUp() override {
        DeterminismTest::SetUp();
        use("cornell", {"--resolution", "12x12"});
    }
};

TEST_F(Balance, is_told_in_the_statistics) {
    const auto s = stats("15:18");
    ASSERT_EQ(s["epochs"].size(), 2U);
    EXPECT_EQ(s["epochs"][0]["epoch"], 0);
    EXPECT_EQ(s["epochs"][0]["passes"], 1);
    EXPECT_EQ(s["epochs"][1]["epoch"], 1);
    EXPECT_EQ(s["epochs"][0]["photons_per_pass"], 200'000);
    EXPECT_LT(s["epochs"][1]["photons_per_pass"], 200'000);  // 144 pixels need fewer
    EXPECT_EQ(s["epochs"][1]["passes"], 2);
    double paths = 0;
    for (const auto& epoch : s["epochs"]) {
        paths += epoch["photons_per_pass"].get<double>() * epoch["passes"].get<double>();
    }
    EXPECT_EQ(s["photon_paths"]["uniform"], paths);
    EXPECT_FALSE(s["settings"].contains("balance"));
}

TEST_F(Balance, is_off_where_the_user_says_so) {
    const auto s = stats("16:17", {"--balance", "off"});
    EXPECT_EQ(s["epochs"][0]["photons_per_pass"], 200'000);
    EXPECT_EQ(s["settings"]["balance"], "off");
    const auto given = stats("16:17", {"--photons-per-pass", "777"});
    EXPECT_EQ(given["epochs"][0]["photons_per_pass"], 777);
    for (const Words& words :
         {Words{"--balance", "on"}, Words{"--balance", "off", "--photon-sampler", "uniform"},
          Words{"--balance", "auto", "--photons-per-pass", "777"},
          Words{"--balance", "auto", "--mode", "paper"},
          Words{"--balance", "auto", "--integrator", "path"}}) {
        const Ran ran = run(Words{"render", "cornell.pbrt", "-o", "y.exr"} + words);
        EXPECT_EQ(ran.code, 2) << words.back();
        EXPECT_NE(ran.err.find("--balance"), std::string::npos) << ran.err;
        EXPECT_FALSE(exists("y.exr"));
    }
}

TEST_F(Balance, films_with_and_without_do_not_mix) {
    part("a", "0:1", 1);
    part("b", "1:2", 1, {"--balance", "off"});
    const Ran merged = run({"merge", "a.film", "b.film", "-o", "x.exr"});
    EXPECT_EQ(merged.code, 2);
    EXPECT_NE(merged.err.find("balance"), std::string::npos) << merged.err;
}

/// In two epochs, of which the second is balanced.
TEST_F(Balance, same_bytes_for_any_threads_and_cuts) {
    expect_same_bytes(18, 15, {14, 17, 18});
}

}  // namespace
}  // namespace sunfleck
