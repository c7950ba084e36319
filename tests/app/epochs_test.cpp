// Epochs and adaptive pixel sampling as a user meets them: the statistics, the flags.
#include "app/determinism_support.h"

namespace sunfleck::engine {
namespace {

using testing_support::DeterminismTest;

class Epochs : public DeterminismTest {};

TEST_F(Epochs, are_told_in_the_statistics) {
    use("cornell", {"--resolution", "12x12", "--indirect", "photons"});
    const auto s = stats("15:18");
    ASSERT_EQ(s["epochs"].size(), 2U);
    EXPECT_EQ(s["epochs"][0]["epoch"], 0);
    EXPECT_EQ(s["epochs"][0]["passes"], 1);
    EXPECT_EQ(s["epochs"][1]["epoch"], 1);
    EXPECT_EQ(s["epochs"][1]["passes"], 2);
    double paths = 0;
    for (const auto& epoch : s["epochs"]) {
        EXPECT_EQ(epoch["photons_per_pass"], 200'000);
        paths += epoch["photons_per_pass"].get<double>() * epoch["passes"].get<double>();
    }
    EXPECT_EQ(s["photon_paths"]["uniform"], paths);
    const auto given = stats("16:17", {"--photons-per-pass", "777"});
    EXPECT_EQ(given["epochs"][0]["photons_per_pass"], 777);
}

TEST_F(Epochs, have_more_camera_paths_in_noisy_pixels_unless_told_not_to) {
    use("diamond", {"--resolution", "24x24"});
    EXPECT_GT(stats("15:16")["epochs"][0]["camera_paths_per_pixel"], 1);
    const auto off = stats("15:18", {"--adaptive-pixels", "off"});
    for (const auto& even : off["epochs"]) EXPECT_EQ(even["camera_paths_per_pixel"], 1);
}

}  // namespace
}  // namespace sunfleck::engine
