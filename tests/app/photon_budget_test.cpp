// The photon budget and adaptive pixel sampling as a user meets them: the flags, the statistics.
#include "app/determinism_support.h"

namespace sunfleck::engine {
namespace {

using testing_support::DeterminismTest;

class Balance : public DeterminismTest {
protected:
    void SetUp() override {
        DeterminismTest::SetUp();
        use("cornell", {"--resolution", "12x12", "--indirect", "photons"});
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
    EXPECT_EQ(s["epochs"][0]["subpasses_per_pass"], 1);
    EXPECT_GE(s["epochs"][1]["subpasses_per_pass"], 1);
    EXPECT_EQ(s["epochs"][0]["weight"], 1);
    EXPECT_EQ(s["epochs"][1]["weight"], 1);
    EXPECT_EQ(s["epochs"][1]["passes"], 2);
    double paths = 0;
    for (const auto& epoch : s["epochs"])
        paths += epoch["photons_per_pass"].get<double>() * epoch["passes"].get<double>();
    EXPECT_EQ(s["photon_paths"]["uniform"], paths);
}

TEST_F(Balance, passes_of_more_photons_count_more_than_once) {
    use("keyhole-4", {"--resolution", "48x48", "--indirect", "photons"});
    const auto s = stats("15:17");
    EXPECT_EQ(s["epochs"][0]["weight"], 1);
    EXPECT_EQ(s["epochs"][1]["photons_per_pass"], 400'000);
    EXPECT_EQ(s["epochs"][1]["weight"], 2);
}

TEST_F(Balance, is_off_where_the_user_says_so) {
    const auto s = stats("16:17", {"--photon-budget", "off"});
    EXPECT_EQ(s["epochs"][0]["photons_per_pass"], 200'000);
    const auto given = stats("16:17", {"--photons-per-pass", "777"});
    EXPECT_EQ(given["epochs"][0]["photons_per_pass"], 777);
}

TEST_F(Balance, adaptive_pixels_are_told_in_the_statistics_and_can_be_left_out) {
    use("diamond", {"--resolution", "24x24"});
    const auto s = stats("15:16");
    const auto& epoch = s["epochs"][0];
    EXPECT_GT(epoch["camera_paths_per_pixel"], epoch["subpasses_per_pass"]);
    const auto off = stats("15:18", {"--adaptive-pixels", "off"});
    for (const auto& even : off["epochs"])
        EXPECT_EQ(even["camera_paths_per_pixel"], even["subpasses_per_pass"]);
}

}  // namespace
}  // namespace sunfleck::engine
