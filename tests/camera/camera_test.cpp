// Cameras: field of view, corners, mirror images, sharpness, footprint.
#include "camera/camera.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

const Matrix kIdentity;
constexpr double kDegree = kPiDouble / 180;

/// Where the ray meets the plane at distance z in front of an unmoved camera.
Vec3d at_depth(const CameraRay& ray, double z) {
    return ray.origin + ray.direction * ((z - ray.origin.z) / ray.direction.z);
}

TEST(Camera, fov_is_that_of_the_shorter_axis) {
    const PerspectiveCamera wide = make_perspective(kIdentity, {400, 200}, 50, 2, {});
    EXPECT_NEAR(at_depth(wide.ray({200, 0}, {.5, .5}), 1).y, std::tan(25 * kDegree), 1e-14);
    EXPECT_NEAR(at_depth(wide.ray({400, 100}, {.5, .5}), 1).x, 2 * std::tan(25 * kDegree), 1e-14);
    const PerspectiveCamera tall = make_perspective(kIdentity, {200, 400}, 50, 0.5, {});
    EXPECT_NEAR(at_depth(tall.ray({200, 200}, {.5, .5}), 1).x, std::tan(25 * kDegree), 1e-14);
    EXPECT_NEAR(at_depth(tall.ray({100, 0}, {.5, .5}), 1).y, 2 * std::tan(25 * kDegree), 1e-14);
}

TEST(Camera, looks_along_z_with_row_zero_on_top_and_x_to_the_right) {
    const PerspectiveCamera camera = make_perspective(kIdentity, {64, 64}, 90, 1, {});
    const CameraRay middle = camera.ray({32, 32}, {.5, .5});
    EXPECT_EQ(middle.origin, Vec3d(0));
    EXPECT_EQ(middle.direction, Vec3d(0, 0, 1));
    const Vec3d top_left = at_depth(camera.ray({0, 0}, {.5, .5}), 1);
    EXPECT_NEAR((top_left - Vec3d(-1, 1, 1)).length(), 0, 1e-14);
    const Vec3d bottom_right = at_depth(camera.ray({64, 64}, {.5, .5}), 1);
    EXPECT_NEAR((bottom_right - Vec3d(1, -1, 1)).length(), 0, 1e-14);
}

TEST(Camera, screen_window_overrides_the_span) {
    const std::array<double, 4> window = {-0.5, 1, -2, 0.25};
    const PerspectiveCamera camera = make_perspective(kIdentity, {10, 10}, 90, 1, window);
    const Vec3d top_left = at_depth(camera.ray({0, 0}, {.5, .5}), 1);
    EXPECT_NEAR((top_left - Vec3d(-0.5, 0.25, 1)).length(), 0, 1e-14);
    const Vec3d bottom_right = at_depth(camera.ray({10, 10}, {.5, .5}), 1);
    EXPECT_NEAR((bottom_right - Vec3d(1, -2, 1)).length(), 0, 1e-14);
}

TEST(Camera, a_mirroring_matrix_mirrors_the_picture) {
    Matrix mirror;
    mirror[0][0] = -1;
    const PerspectiveCamera camera = make_perspective(mirror, {64, 64}, 90, 1, {});
    const Vec3d top_left = at_depth(camera.ray({0, 0}, {.5, .5}), 1);
    EXPECT_NEAR((top_left - Vec3d(1, 1, 1)).length(), 0, 1e-14);
}

TEST(Camera, matrix_moves_points_as_row_vectors) {
    Matrix moved;  // x to y, y to z, z to x; then to (5, 6, 7)
    moved = Matrix(0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 5, 6, 7, 1);
    const PerspectiveCamera camera = make_perspective(moved, {64, 64}, 90, 1, {});
    const CameraRay ray = camera.ray({64, 32}, {.5, .5});
    EXPECT_EQ(ray.origin, Vec3d(5, 6, 7));
    EXPECT_NEAR((ray.direction - Vec3d(1, 1, 0) / std::sqrt(2.0)).length(), 0, 1e-14);
}

TEST(Camera, rays_of_one_film_point_meet_in_the_focal_plane) {
    PerspectiveCamera camera = make_perspective(kIdentity, {64, 64}, 60, 1, {});
    const Vec3d sharp = at_depth(camera.ray({10, 50}, {.5, .5}), 7.5);
    camera.lens_radius = 0.25;
    camera.focal_distance = 7.5;
    double widest = 0;
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j) {
            const CameraRay ray = camera.ray({10, 50}, {(i + 0.5) / 10, (j + 0.5) / 10});
            EXPECT_NEAR((at_depth(ray, 7.5) - sharp).length(), 0, 1e-13);
            EXPECT_NEAR(ray.direction.length(), 1, 1e-15);
            EXPECT_LE(ray.origin.length(), 0.25);
            widest = std::max(widest, ray.origin.length());
        }
    EXPECT_GT(widest, 0.2);
}

/// All pixels' solid angles together are the picture's: a square pyramid of 90 degrees is a sixth
/// of the sphere, whatever similarity the camera stands under.
TEST(Camera, footprints_squared_add_up_to_the_solid_angle) {
    for (const double scale : {1.0, -3.0}) {
        Matrix matrix;
        matrix.setScale(scale);
        const PerspectiveCamera camera = make_perspective(matrix, {64, 64}, 90, 1, {});
        double sum = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const auto width =
                    static_cast<double>(camera.ray({x + 0.5, y + 0.5}, {.5, .5}).footprint_angle);
                sum += width * width;
            }
        EXPECT_NEAR(sum, 4 * kPiDouble / 6, 2e-4);
    }
}

/// A camera squeezed to half its height sees what one with half the screen's height sees.
TEST(Camera, footprint_follows_a_squeezing_matrix) {
    Matrix squeezed;
    squeezed[1][1] = 0.5;
    const PerspectiveCamera a = make_perspective(squeezed, {64, 64}, 90, 1, {});
    const std::array<double, 4> window = {-1, 1, -0.5, 0.5};
    const PerspectiveCamera b = make_perspective(kIdentity, {64, 64}, 90, 1, window);
    for (const Vec2d& film : {Vec2d(32, 32), Vec2d(3, 60)}) {
        const CameraRay squeezed_ray = a.ray(film, {.5, .5});
        const CameraRay plain_ray = b.ray(film, {.5, .5});
        EXPECT_NEAR((squeezed_ray.direction - plain_ray.direction).length(), 0, 1e-15);
        EXPECT_FLOAT_EQ(squeezed_ray.footprint_angle, plain_ray.footprint_angle);
    }
}

OrthographicCamera orthographic() {
    OrthographicCamera camera;
    camera.resolution = {40, 20};
    set_screen(camera, 2, {});
    return camera;
}

TEST(Orthographic, rays_are_parallel_and_as_wide_as_their_pixel) {
    OrthographicCamera camera = orthographic();
    for (const Vec2d& film : {Vec2d(0, 0), Vec2d(20, 10), Vec2d(40, 20)}) {
        const CameraRay ray = camera.ray(film, {.3, .7});
        EXPECT_EQ(ray.direction, Vec3d(0, 0, 1));
        EXPECT_NEAR((ray.origin - Vec3d(film.x / 10 - 2, 1 - film.y / 10, 0)).length(), 0, 1e-14);
        EXPECT_FLOAT_EQ(ray.footprint, 0.1F);
        EXPECT_EQ(ray.footprint_angle, 0);
    }
    camera.camera_to_world.setScale(3.0);
    EXPECT_FLOAT_EQ(camera.ray({20, 10}, {.5, .5}).footprint, 0.3F);
}

TEST(Orthographic, rays_of_one_film_point_meet_in_the_focal_plane) {
    OrthographicCamera camera = orthographic();
    camera.lens_radius = 0.25;
    camera.focal_distance = 4;
    const Vec3d sharp(10.0 / 10 - 2, 1 - 5.0 / 10, 4);
    double widest = 0;
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j) {
            const CameraRay ray = camera.ray({10, 5}, {(i + 0.5) / 10, (j + 0.5) / 10});
            EXPECT_NEAR((at_depth(ray, 4) - sharp).length(), 0, 1e-13);
            widest = std::max(widest, (ray.origin - Vec3d(sharp.x, sharp.y, 0)).length());
        }
    EXPECT_GT(widest, 0.2);
    EXPECT_LE(widest, 0.25 + 1e-15);
}

/// All pixels' solid angles together are the sphere's, and no direction is left out.
TEST(Spherical, pixels_tile_the_sphere) {
    for (const SphereMap map : {SphereMap::equal_area, SphereMap::equirectangular}) {
        const SphericalCamera camera{kIdentity, {64, 64}, map};
        double sum = 0;
        Vec3d moment(0);
        Vec3d squares(0);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const CameraRay ray = camera.ray({x + 0.5, y + 0.5}, {.5, .5});
                const double part = static_cast<double>(ray.footprint_angle) * ray.footprint_angle;
                sum += part;
                moment += ray.direction * part;
                squares += ray.direction * ray.direction * part;
            }
        EXPECT_NEAR(sum, 4 * kPiDouble, 0.005);
        EXPECT_NEAR(moment.length(), 0, 1e-3);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(squares[c], 4 * kPiDouble / 3, 0.01) << c;
    }
}

TEST(Spherical, y_is_up) {
    const SphericalCamera map{kIdentity, {64, 32}, SphereMap::equirectangular};
    const auto towards = [](const SphericalCamera& camera, double x, double y) {
        return camera.ray({x, y}, {.5, .5}).direction;
    };
    EXPECT_NEAR((towards(map, 10, 0) - Vec3d(0, 1, 0)).length(), 0, 1e-14);
    EXPECT_NEAR((towards(map, 0, 16) - Vec3d(1, 0, 0)).length(), 0, 1e-14);
    EXPECT_NEAR((towards(map, 16, 16) - Vec3d(0, 0, 1)).length(), 0, 1e-14);
    const SphericalCamera square{kIdentity, {64, 64}, SphereMap::equal_area};
    EXPECT_NEAR((towards(square, 32, 32) - Vec3d(0, 1, 0)).length(), 0, 1e-14);
    EXPECT_NEAR((towards(square, 64, 32) - Vec3d(1, 0, 0)).length(), 0, 1e-7);
    // Beyond an edge the square goes on where it was folded.
    EXPECT_NEAR((towards(square, 65, 20) - towards(square, 63, 44)).length(), 0, 1e-12);
}

TEST(Resolution, keeps_the_middle_and_the_shorter_axis) {
    Camera camera = orthographic();
    set_resolution(camera, {10, 30});
    const auto& tall = std::get<OrthographicCamera>(camera);
    EXPECT_NEAR(tall.screen_max.x, 1, 1e-15);
    EXPECT_NEAR(tall.screen_max.y, 3, 1e-15);
    Camera sphere = SphericalCamera{kIdentity, {64, 64}, SphereMap::equal_area};
    set_resolution(sphere, {16, 8});
    EXPECT_EQ(std::get<SphericalCamera>(sphere).resolution, Vec2i(16, 8));
}

}  // namespace
}  // namespace sunfleck::engine
