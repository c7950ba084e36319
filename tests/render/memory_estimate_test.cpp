// The estimate of a render's memory knows what the render will keep. How near it is to measured
// peaks is in docs/reference/render.md: they are the allocator's and the machine's, too.
#include "render/memory_estimate.h"

#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

class MemoryEstimates : public ::testing::Test {
protected:
    MemoryEstimate estimate() const { return render_bytes({scene_, settings_, {}}); }

    Scene scene_ = scene_of(view("0 -4 2  0 0 0.5  0 0 1", 40, 500) + diffuse("1 1 1") +
                            quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0") +
                            "LightSource \"point\" \"point3 from\" [0 0 2]\n");
    RenderSettings settings_;
};

TEST_F(MemoryEstimates, leave_room_for_many_camera_paths_where_noise_may_ask_for_them) {
    EXPECT_GT(estimate().most, 2 * estimate().usual);
    settings_.photon.adaptive_pixels = false;
    EXPECT_EQ(estimate().most, estimate().usual);
    settings_.photon = {};
    settings_.photon.sampler = PhotonSampler::uniform;  // learns nothing
    EXPECT_EQ(estimate().most, estimate().usual);
}

TEST_F(MemoryEstimates, count_layers_and_photons) {
    settings_.photon.sampler = PhotonSampler::uniform;
    const std::uint64_t plain = estimate().usual;
    settings_.aovs[static_cast<std::size_t>(Aov::direct)] = true;
    const std::uint64_t pixels = 500 * 500;
    EXPECT_GT(estimate().usual, plain + 3 * 16 * pixels) << "three exact sums in the film alone";
    settings_.aovs = {};
    settings_.photon.paths_per_pass = 1000;
    EXPECT_LT(estimate().usual, plain);
    settings_.photon.paths_per_pass = 4'000'000;
    const std::uint64_t many = estimate().usual;
    settings_.photon.paths_per_pass = 1'000'000;
    EXPECT_EQ(estimate().usual, many) << "photons are traced some at a time";
}

TEST_F(MemoryEstimates, of_references_have_no_visible_points) {
    const std::uint64_t with_points = estimate().usual;
    settings_.integrator = Integrator::path;
    EXPECT_LT(estimate().usual, with_points / 2);
}

}  // namespace
}  // namespace sunfleck::engine
