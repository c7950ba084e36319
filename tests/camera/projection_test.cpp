// How points are seen: the inverse of the camera's rays, and the size of what is seen.
#include "camera/projection.h"

#include "core/random.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

Matrix placed() {
    Matrix matrix;
    matrix.rotate(Vec3d(0.4, -0.7, 0.2));
    matrix.translate(Vec3d(1, 2, -0.5));
    matrix.scale(Vec3d(-1.5, 1.5, 1.5));
    return matrix;
}

PerspectiveCamera perspective() {
    return make_perspective(placed(), {64, 40}, 50, 1.6, {});
}

OrthographicCamera orthographic() {
    OrthographicCamera camera;
    static_cast<ScreenCamera&>(camera) = perspective();
    return camera;
}

/// The same camera, with a lens.
template <class C>
C with_lens(C camera) {
    camera.lens_radius = 0.1;
    camera.focal_distance = 3;
    return camera;
}

struct Case {
    std::string name;
    Camera camera;
};
std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.name;
}

std::vector<Case> cases() {
    return {{"pinhole", perspective()},
            {"thin_lens", with_lens(perspective())},
            {"orthographic", orthographic()},
            {"orthographic_with_lens", with_lens(orthographic())},
            {"equal_area", SphericalCamera{placed(), {64, 40}, SphereMap::equal_area}},
            {"equirectangular", SphericalCamera{placed(), {64, 40}, SphereMap::equirectangular}}};
}

class EveryCamera : public testing::TestWithParam<Case> {};

TEST_P(EveryCamera, sees_a_point_of_a_ray_where_the_ray_began) {
    const Projection projection(GetParam().camera);
    RandomStream random(1, Purpose::test, 0, 0);
    for (int i = 0; i < 200; ++i) {
        const double x = 64 * random.next();
        const Vec2d film(x, 40 * random.next());
        const double u = random.next();
        const Vec2d lens(u, random.next());
        const CameraRay ray = camera_ray(GetParam().camera, film, lens);
        const Vec3d point = ray.origin + ray.direction * (0.5 + 8 * random.next());
        const auto sight = projection.sight_of(point, lens);
        ASSERT_TRUE(sight);
        EXPECT_LT((sight->film - film).length(), 1e-4);
        EXPECT_LT((sight->origin - ray.origin).length(), 1e-9);
    }
}

/// A small square across the ray, seen from the same place: its size on the film by differences.
TEST_P(EveryCamera, tells_the_size_on_the_film) {
    const Projection projection(GetParam().camera);
    RandomStream random(2, Purpose::test, 0, 0);
    for (int i = 0; i < 50; ++i) {
        const double column = 4 + 56 * random.next();
        const Vec2d film(column, 4 + 32 * random.next());
        const Vec2d lens(0.3, 0.8);
        const CameraRay ray = camera_ray(GetParam().camera, film, lens);
        const Vec3d point = ray.origin + ray.direction * 4.0;
        const Vec3d x = ray.direction.cross(Vec3d(0.3, 0.5, 0.8)).normalized() * 1e-2;
        const Vec3d y = ray.direction.cross(x);
        const auto film_of = [&](const Vec3d& p) { return projection.sight_of(p, lens)->film; };
        const Vec2d along_x = (film_of(point + x) - film_of(point - x)) / 2.0;
        const Vec2d along_y = (film_of(point + y) - film_of(point - y)) / 2.0;
        const double area = std::abs(along_x.x * along_y.y - along_x.y * along_y.x) / 1e-4;
        EXPECT_NEAR(projection.sight_of(point, lens)->area / area, 1, 5e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(all, EveryCamera, testing::ValuesIn(cases()),
                         [](const auto& info) { return info.param.name; });

TEST(Projection, what_is_behind_is_not_seen) {
    const CameraRay ray = perspective().ray({32, 20}, {0.5, 0.5});
    const Projection projection{Camera(perspective())};
    EXPECT_TRUE(projection.sight_of(ray.origin + ray.direction, {0.5, 0.5}));
    EXPECT_FALSE(projection.sight_of(ray.origin - ray.direction, {0.5, 0.5}));
    EXPECT_FALSE(projection.sight_of(ray.origin, {0.5, 0.5}));
}

}  // namespace
}  // namespace sunfleck::engine
