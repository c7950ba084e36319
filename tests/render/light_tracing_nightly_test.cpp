// Light tracing against path tracing, and against photons where that finds nothing.
#include "render/light_equivalence.h"

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

/// The lamp is in view too, and a filter that reaches over pixels.
TEST(LightTracingNightly, of_a_room) {
    const std::string camera =
        "LookAt 0 -3 1  0 0 1  0 0 1\nCamera \"perspective\" \"float fov\" 45\n"
        "Film \"rgb\" \"integer xresolution\" 32 \"integer yresolution\" 32\n"
        "PixelFilter \"mitchell\" \"float xradius\" 2 \"float yradius\" 2\nWorldBegin\n";
    expect_equal(scene_of(camera + room_with_metal() + kLamp), Integrator::path, {24});
}

TEST(LightTracingNightly, of_all_directions) {
    const std::string camera =
        "LookAt 0 -.5 1  0 0 1  0 0 1\nCamera \"spherical\"\n" + film(32) + "WorldBegin\n";
    expect_equal(scene_of(camera + room_with_metal() + kLamp), Integrator::path, {40});
}

TEST(LightTracingNightly, in_parallel) {
    const std::string camera =
        "LookAt 0 -3 1  0 0 1  0 0 1\nCamera \"orthographic\" \"float screenwindow\" "
        "[-.9 .9 -.9 .9]\n" +
        film(32) + "WorldBegin\n";
    expect_equal(scene_of(camera + room_with_metal() + kLamp), Integrator::path, {24});
}

/// A caustic of the sun: no path from the camera can find it.
TEST(LightTracingNightly, of_a_caustic) {
    const Scene scene =
        scene_of(view("2 -1 1  .57 -.2 0  0 0 1", 22, 32) +
                 "LightSource \"distant\" \"point3 from\" [-1 0 1.2]\n" + diffuse("0.7 0.7 0.7") +
                 quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") +
                 "Material \"dielectric\" \"spectrum eta\" \"glass-F11\"\nTranslate -.1 -.2 .8\n"
                 "Shape \"sphere\" \"float radius\" 0.4\n");
    expect_equal(scene, Integrator::sppm, {40, 0.015});
}

}  // namespace
}  // namespace sunfleck::engine
