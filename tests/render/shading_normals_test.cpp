// Photons and shading normals: light as bright as direct light that is sampled, also where facets
// of a mesh meet and a disc accepts photons of both.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

RenderSettings settings_with(DirectLight direct) {
    RenderSettings settings;
    settings.transport = {direct, 1};
    settings.photon.paths_per_pass = 20'000;
    settings.camera.radius = 0.1;
    settings.seed = 8;
    return settings;
}

std::string sun_from(const std::string& point) {
    return R"(LightSource "distant" "rgb L" [3 3 3] "point3 from" [)" + point +
           "] \"point3 to\" [0 0 0]\n" + diffuse(".8 .8 .8");
}

/// Two facets 30 degrees apart along an edge in the middle, and normals that change smoothly over
/// it; the sun grazes the right one by 3 degrees. By its own cosine in place of the photons' a
/// point near the edge would be 8 times as bright.
TEST(ShadingNormals, edges_of_smooth_meshes_have_no_seams) {
    const std::string text = view("0 3 -.01  0 0 0  0 1 0", 20, 16) + sun_from("-1 .05 0") +
                             R"(Shape "trianglemesh" "point3 P" [
    -2 -1.1547 -3  0 0 -3  0 0 3  -2 -1.1547 3  2 0 -3  2 0 3]
"integer indices" [0 1 2 0 2 3 1 4 5 1 5 2] "normal N" [
    -.5 .866 0  -.2588 .9659 0  -.2588 .9659 0  -.5 .866 0  0 1 0  0 1 0]
)";
    const Scene scene = scene_of(text);
    const MeanPicture sampled = render_mean(scene, settings_with(DirectLight::sampled), 4);
    const MeanPicture photons = render_mean(scene, settings_with(DirectLight::photons), 128);
    for (int x = 0; x < 16; ++x) {
        const double expected = luminance(sampled.mean(x, 0, x + 1, 16));
        EXPECT_NEAR(luminance(photons.mean(x, 0, x + 1, 16)), expected, 0.1 * expected) << x;
    }
}

/// The surface is lit from the side that is seen, its shading normal is not: a bsdf is zero then.
TEST(ShadingNormals, light_from_behind_them_is_not_seen) {
    const std::string text = view("0 3 -.01  0 0 0  0 1 0", 20, 8) + sun_from("-2 1 0") +
                             R"(Shape "trianglemesh" "point3 P" [-3 0 -3  3 0 -3  3 0 3  -3 0 3]
"integer indices" [0 1 2 0 2 3] "normal N" [1 1 0  1 1 0  1 1 0  1 1 0]
)";
    const Scene scene = scene_of(text);
    for (const DirectLight direct : {DirectLight::sampled, DirectLight::photons}) {
        const MeanPicture picture = render_mean(scene, settings_with(direct), 2);
        EXPECT_EQ(picture.mean(), Vec3d(0));
    }
    EXPECT_GT(
        render_mean(scene, settings_with(DirectLight::photons), 2).statistics[Count::deposits], 0U);
}

}  // namespace
}  // namespace sunfleck::engine
