// A wall under tungsten light: allocated_budget to it, the wall is grey.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

Vec3d wall(const std::string& film_parameters) {
    const Scene scene = scene_of(
        "LookAt 0 0 1  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\nFilm \"rgb\" "
        "\"integer xresolution\" 8 \"integer yresolution\" 8 " +
        film_parameters +
        "\nWorldBegin\nLightSource \"point\" \"spectrum I\" \"stdillum-A\" \"point3 from\" [0 0 "
        "1]\n" +
        diffuse("0.5 0.5 0.5") + quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0"));
    RenderSettings settings;
    settings.photon.paths_per_pass = 100;
    return render_mean(scene, settings, 16).mean();
}

TEST(WhiteBalanceOfFilm, makes_the_light_white) {
    const Vec3d warm = wall("");
    EXPECT_GT(warm.x, 3 * warm.z);
    const Vec3d grey = wall("\"float whitebalance\" 2856");
    EXPECT_NEAR(grey.x / grey.y, 1, 0.02);
    EXPECT_NEAR(grey.z / grey.y, 1, 0.04);
    EXPECT_NEAR(luminance(grey) / luminance(warm), 1, 0.02);
}

}  // namespace
}  // namespace sunfleck::engine
