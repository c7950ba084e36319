// The camera: where it stands, what it sees.
#include "import/pbrt/camera.h"

#include "import/pbrt/scene_text.h"

namespace sunfleck::engine {
namespace {

PerspectiveCamera with(const std::string& options) {
    return std::get<PerspectiveCamera>(read_text(options + "\nWorldBegin").camera);
}

TEST(Camera, stands_at_the_origin_by_default) {
    const PerspectiveCamera camera = with("");
    EXPECT_EQ(camera.camera_to_world, Matrix());
    EXPECT_EQ(camera.resolution, Vec2i(1280, 720));
    EXPECT_NEAR(camera.screen_max.y, 1, 1e-12);
    EXPECT_NEAR(camera.screen_max.x, 1280.0 / 720, 1e-12);
    EXPECT_EQ(camera.lens_radius, 0);
    EXPECT_EQ(camera.focal_distance, 1e6);
}

TEST(Camera, is_placed_by_the_matrix_at_its_statement) {
    const PerspectiveCamera camera =
        with("Scale -1 1 1 LookAt 1 2 3 1 2 9 0 1 0 Camera \"perspective\" Translate 7 7 7");
    const Vec3d origin = Vec3d(0) * camera.camera_to_world;
    EXPECT_TRUE(origin.equalWithAbsError({1, 2, 3}, 1e-12));
    const Vec3d right = Vec3d(1, 0, 0) * camera.camera_to_world - origin;
    EXPECT_TRUE(right.equalWithAbsError({-1, 0, 0}, 1e-12));
}

TEST(Camera, sees_the_size_of_a_later_film) {
    const PerspectiveCamera camera = with(
        "Camera \"perspective\" \"float fov\" 53.13010235 \"float lensradius\" .1 \"float "
        "focaldistance\" 4 Film \"rgb\" \"integer xresolution\" 10 \"integer yresolution\" "
        "20");
    EXPECT_EQ(camera.resolution, Vec2i(10, 20));
    EXPECT_NEAR(camera.screen_max.x, 0.5, 1e-9);
    EXPECT_NEAR(camera.screen_max.y, 1, 1e-9);
    EXPECT_EQ(camera.lens_radius, 0.1);
    EXPECT_EQ(camera.focal_distance, 4);
}

TEST(Camera, screen_window_and_aspect_win) {
    const PerspectiveCamera window =
        with("Camera \"perspective\" \"float screenwindow\" [ -1 .5 -.75 2 ]");
    EXPECT_NEAR(window.screen_min.x, -1, 1e-12);
    EXPECT_NEAR(window.screen_max.x, 0.5, 1e-12);
    EXPECT_NEAR(window.screen_min.y, -0.75, 1e-12);
    EXPECT_NEAR(window.screen_max.y, 2, 1e-12);
    EXPECT_NEAR(with("Camera \"perspective\" \"float frameaspectratio\" 3").screen_max.x, 3, 1e-12);
}

TEST(Camera, orthographic_has_a_screen_and_a_lens) {
    const auto camera = std::get<OrthographicCamera>(
        read_text("Camera \"orthographic\" \"float screenwindow\" [ -3 3 -2 2 ] \"float "
                  "lensradius\" .5 \"float focaldistance\" 7\nWorldBegin")
            .camera);
    EXPECT_EQ(camera.screen_min, Vec2d(-3, -2));
    EXPECT_EQ(camera.screen_max, Vec2d(3, 2));
    EXPECT_EQ(camera.lens_radius, 0.5);
    EXPECT_EQ(camera.focal_distance, 7);
}

TEST(Camera, spherical_maps_by_equal_area_unless_told) {
    const auto map_of = [](const std::string& options) {
        return std::get<SphericalCamera>(
                   read_text("Camera \"spherical\"" + options + "\nWorldBegin").camera)
            .map;
    };
    EXPECT_EQ(map_of(""), SphereMap::equal_area);
    EXPECT_EQ(map_of("\"string mapping\" \"equirectangular\""), SphereMap::equirectangular);
}

TEST(Camera, of_two_the_last_counts) {
    const PerspectiveCamera camera = with(
        "Translate 0 0 1 Camera \"perspective\" \"float fov\" 20 "
        "Identity Camera \"perspective\"");
    EXPECT_EQ(camera.camera_to_world, Matrix());
    EXPECT_NEAR(camera.screen_max.y, 1, 1e-12);
}

TEST(Camera, that_cannot_be_is_an_error) {
    for (const char* text :
         {"Camera \"spherical\" \"string mapping\" \"cube\"", "Camera \"realistic\"",
          "Camera \"pinhole\"", "Camera \"perspective\" \"float fov\" 0",
          "Camera \"perspective\" \"float fov\" 180",
          "Camera \"perspective\" \"float screenwindow\" [ 1 -1 1 -1 ]",
          "Camera \"perspective\" \"float frameaspectratio\" 0",
          "Camera \"perspective\" \"float lensradius\" -1",
          "Camera \"perspective\" \"float focaldistance\" 0"})
        EXPECT_NE(error_of(std::string(text) + "\nWorldBegin"), "") << text;
}

}  // namespace
}  // namespace sunfleck::engine
