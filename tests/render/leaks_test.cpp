// Photons light the surface and the side that they meet, and nothing else near them.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr const char* kSunFromAbove =
    "LightSource \"distant\" \"point3 from\" [0 0 1] \"point3 to\" [0 0 0] \"float scale\" 3\n";

RenderSettings with_photons() {
    RenderSettings settings;
    settings.transport.direct = DirectLight::photons;
    settings.photon.paths_per_pass = 50'000;
    settings.camera.radius = 0.2;
    settings.seed = 5;
    return settings;
}

std::string sheet(const std::string& z) {
    return quad("-2 -2 " + z + "  2 -2 " + z + "  2 2 " + z + "  -2 2 " + z);
}

/// Nothing at all: the sun is on the other side of a sheet without thickness.
TEST(Leaks, a_sheet_lit_from_behind_is_black) {
    const Scene scene = scene_of(view("0 0 -3  0 0 0  0 1 0", 20, 8) + kSunFromAbove +
                                 diffuse(".8 .8 .8") + sheet("0"));
    const MeanPicture picture = render_mean(scene, with_photons(), 4);
    EXPECT_EQ(picture.mean(), Vec3d(0));
    EXPECT_EQ(picture.statistics[Count::deposits], 0U);
    // The same from the lit side: the test sees light where there is some.
    const Scene front = scene_of(view("0 0 3  0 0 0  0 1 0", 20, 8) + kSunFromAbove +
                                 diffuse(".8 .8 .8") + sheet("0"));
    EXPECT_NEAR(luminance(render_mean(front, with_photons(), 16).mean()), 3 * 0.8 / kPiDouble,
                0.01);
}

/// The lit sheet is a fifth of the disc's radius behind the one that the camera sees, from its dark
/// side: its photons are within the disc, but face the other way.
TEST(Leaks, sheets_close_together_stay_dark) {
    const Scene below = scene_of(view("0 0 -3  0 0 0  0 1 0", 20, 8) + kSunFromAbove +
                                 diffuse(".8 .8 .8") + sheet("0") + sheet("0.04"));
    EXPECT_EQ(render_mean(below, with_photons(), 4).mean(), Vec3d(0));
}

/// A floor in the shadow of a black sheet, seen by a camera between both. Discs reach up to a
/// quarter of their radius from their surface: a sheet further away than that lends no light.
TEST(Leaks, a_shadowed_floor_takes_no_photon_of_the_sheet_above_it) {
    const Scene scene =
        scene_of(view("-0.2 0 0.04  0 0 0  0 0 1", 10, 8) + kSunFromAbove + diffuse("0 0 0") +
                 sheet("0.06") + diffuse(".8 .8 .8") + sheet("0"));
    RenderSettings settings = with_photons();
    settings.camera.radius = 0.22;
    const MeanPicture picture = render_mean(scene, settings, 4);
    EXPECT_EQ(picture.mean(), Vec3d(0));
    EXPECT_EQ(picture.statistics[Count::visible_points], 4U * 64U);
    EXPECT_GE(picture.statistics[Count::photon_rays], 100'000U);
}

}  // namespace
}  // namespace sunfleck::engine
