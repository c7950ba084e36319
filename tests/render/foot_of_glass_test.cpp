// Where a glass stands on a table: photons on the glass are not the table's, so the foot is as
// bright as it should be, although discs reach across the gap.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// A block of glass, `gap` above a table in the sun, seen from above through the glass.
Scene foot(double gap, const std::string& albedo) {
    return scene_of(view("0 0 6  0 0 0  0 1 0", 3, 8) +
                    "LightSource \"distant\" \"point3 from\" [0 0 1] \"point3 to\" [0 0 0]\n" +
                    diffuse(albedo) + quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") +
                    "Material \"dielectric\" \"float eta\" 1.5\n" +
                    box({-1.5, -1.5, gap}, {1.5, 1.5, gap + 0.5}));
}

Estimate brightness(const Scene& scene, int renders, Aov aov = Aov::total) {
    RenderSettings settings;
    settings.photon.sampler = PhotonSampler::uniform;
    settings.photon.paths_per_pass = 20'000;
    settings.camera.radius = 0.4;
    settings.aovs[static_cast<std::size_t>(Aov::caustic)] = true;
    return Estimate::over(renders, [&](int i) {
        settings.seed = static_cast<std::uint64_t>(i);
        return luminance(render_mean(scene, settings, 16, aov).mean());
    });
}

/// A nearly black table: light crosses the block once, the camera once more.
/// L = rho / pi E T^2, T = (1 - R) / (1 + R), R = 0.04; within 1% with 99% confidence.
TEST(FootOfGlass, a_tenth_of_a_millimetre_above_the_table) {
    const double t = (1 - 0.04) / (1 + 0.04);
    const Estimate seen = brightness(foot(1e-4, "0.002 0.002 0.002"), 12);
    EXPECT_LT(worst_ratio(seen, {0.002 / kPiDouble * t * t, 0}), 0.01) << seen.mean;
}

/// A grey table, whose light goes to and fro below the glass: the gap's width does not matter.

TEST(FootOfGlass, is_as_bright_as_with_a_wider_gap) {
    const Scene narrow = foot(1e-4, "0.5 0.5 0.5");
    const Scene wide = foot(0.02, "0.5 0.5 0.5");
    EXPECT_LT(worst_ratio(brightness(narrow, 8), brightness(wide, 8)), 0.015);
}

}  // namespace
}  // namespace sunfleck::engine
