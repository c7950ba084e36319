// The emission guide as a user meets it: the flag, the statistics, the same bytes however a render
// is cut.
#include "app/determinism_support.h"

namespace sunfleck::engine {
namespace {

using testing_support::DeterminismTest;

class EmissionGuides : public DeterminismTest {
protected:
    void SetUp() override {
        DeterminismTest::SetUp();
        use("keyhole-6", {"--resolution", "12x12", "--photons-per-pass", "3000"});
    }
};

TEST_F(EmissionGuides, are_told_in_the_statistics) {
    const auto s = stats("0:2");
    EXPECT_EQ(s["photon_paths"]["guided"], 2 * 2250);
    EXPECT_GT(s["photon_paths"]["guided_visible"], 20);
    EXPECT_EQ(s["photon_paths"]["uniform_visible"], 0);
    // Chains within what the map covers bring nothing there.
    EXPECT_EQ(s["photon_paths"]["deposited"], s["photon_paths"]["guided_visible"]);
    EXPECT_GT(s["visible_fraction"]["value"], 8e-7);  // 1e-6, and what wide discs add
    EXPECT_LT(s["visible_fraction"]["value"], 2.5e-6);
    EXPECT_GT(s["visible_fraction"]["std_error"], 0);
    EXPECT_LT(s["visible_fraction"]["std_error"], 5e-7);
    EXPECT_EQ(s["starved_passes"], 0);
}

TEST_F(EmissionGuides, are_left_out_where_the_user_says_so) {
    EXPECT_EQ(stats("0:1", {"--emission-guide", "off"})["photon_paths"]["guided"], 0);
}

TEST_F(EmissionGuides, have_the_same_bytes_for_any_threads_and_parts) {
    expect_same_bytes(3, 1, {1, 3});
}

}  // namespace
}  // namespace sunfleck::engine
