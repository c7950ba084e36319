// Spherical films have no edge: light that arrives at the seam or a pole counts on both sides of
// it.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// The inside of a ball under a light near its centre, through a filter of three pixels.
Scene ball(const std::string& mapping, const std::string& size) {
    return scene_of(R"(Camera "spherical" "string mapping" ")" + mapping + "\"\nFilm \"rgb\" " +
                    size + R"(
PixelFilter "gaussian" "float xradius" 1.5 "float yradius" 1.5
WorldBegin
LightSource "point" "rgb I" [8 8 8] "point3 from" [0.01 0 0]
)" + diffuse(".5 .5 .5") +
                    "Shape \"sphere\" \"float radius\" 1\n");
}

class SphericalFilms : public ::testing::TestWithParam<Integrator> {
protected:
    /// Of the outermost columns and rows.
    static Estimate rim(const Scene& scene, Integrator integrator) {
        RenderSettings settings;
        settings.integrator = integrator;
        settings.photon.paths_per_pass = 4000;
        settings.transport.max_depth = 1;
        const std::uint32_t passes = integrator == Integrator::path ? 64 : 16;
        return Estimate::over(16, [&](int i) {
            settings.seed = static_cast<std::uint64_t>(i);
            const MeanPicture picture = render_mean(scene, settings, passes);
            const int w = picture.width;
            const int h = picture.height;
            const Vec3d sum = picture.mean(0, 0, 1, h) + picture.mean(w - 1, 0, w, h) +
                              picture.mean(0, 0, w, 1) + picture.mean(0, h - 1, w, h);
            return luminance(sum);
        });
    }
};

/// 13% would be missing at the sides, 20% at the poles.
TEST_P(SphericalFilms, have_no_dark_rim) {
    for (const bool equal_area : {true, false}) {
        const std::string width = equal_area ? "8" : "12";
        const std::string height = equal_area ? "8" : "6";
        const Scene scene =
            ball(equal_area ? "equalarea" : "equirectangular",
                 "\"integer xresolution\" " + width + " \"integer yresolution\" " + height);
        EXPECT_LT(worst_ratio(rim(scene, GetParam()), rim(scene, Integrator::path)), 0.03);
    }
}

INSTANTIATE_TEST_SUITE_P(By, SphericalFilms,
                         ::testing::Values(Integrator::light, Integrator::bdpt, Integrator::mlt),
                         [](const auto& info) { return std::string(name_of(info.param)); });

}  // namespace
}  // namespace sunfleck::engine
