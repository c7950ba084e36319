// Cylinders and sectors of them, traced through Geometry, against closed forms.
#include "geometry/cylinder.h"

#include "geometry/measure.h"
#include "geometry/sweep.h"
#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using test::Dice;
using test::distance;
using test::of_one;

/// The nearest of the points where x^2 + y^2 = r^2 that is on the part.
std::optional<Vec3d> nearest_by_textbook(const Cylinder& c, const Vec3d& o, const Vec3d& d) {
    const double a = d.x * d.x + d.y * d.y;
    const double b = o.x * d.x + o.y * d.y;
    const double rest = b * b - a * (o.x * o.x + o.y * o.y - c.radius * c.radius);
    if (rest < 0) return {};
    for (const double root : {-std::sqrt(rest), std::sqrt(rest)}) {
        const Vec3d p = o + d * ((root - b) / a);
        const double angle = std::atan2(p.y, p.x) + (p.y < 0 ? kFullCircle : 0);
        if (root > b && p.z > c.z_min && p.z < c.z_max && angle < c.phi_max) return p;
    }
    return {};
}

TEST(Cylinder, is_a_sector_between_its_heights) {
    Dice dice(13);
    int hits = 0;
    for (const double turn : {1.0, 3.0, 5.0, kFullCircle}) {
        const Cylinder cylinder{1.5, -0.5, 2, turn};
        const Geometry geometry = of_one(cylinder);
        for (int i = 0; i < 5000; ++i) {
            const Ray ray = test::ray_between(dice.direction() * 6, dice.in_box(2));
            const auto p = nearest_by_textbook(cylinder, Vec3d(ray.origin), Vec3d(ray.direction));
            const auto hit = geometry.intersect(ray);
            ASSERT_EQ(hit.has_value(), p.has_value());
            EXPECT_EQ(geometry.occluded(ray), p.has_value());
            if (!hit) continue;
            ++hits;
            const double angle = std::atan2(p->y, p->x) + (p->y < 0 ? kFullCircle : 0);
            EXPECT_LT(distance(Vec3d(hit->position), *p), 1e-6);
            EXPECT_LT(distance(Vec3d(hit->normal), Vec3d(p->x, p->y, 0) / 1.5), 1e-6);
            EXPECT_NEAR(hit->uv.x, angle / turn, 1e-6);
            EXPECT_NEAR(hit->uv.y, (p->z + 0.5) / 2.5, 1e-6);
            EXPECT_LT(distance(Vec3d(hit->tangent), Vec3d(-p->y, p->x, 0) * turn), 1e-5);
        }
    }
    EXPECT_GT(hits, 5000);
}

/// dp/du x dp/dv points outwards: so does the normal, under every matrix; flip turns it.
TEST(Cylinder, keeps_its_outside) {
    for (const bool flip : {false, true})
        for (const double x : {1.0, -2.0})
            for (const double z : {1.0, -1.0}) {
                const Geometry geometry = of_one(Cylinder{}, test::scaling(x, 1, z), flip);
                const auto outside = geometry.intersect({{0, 5, 0}, {0, -1, 0}});
                ASSERT_TRUE(outside);
                EXPECT_EQ(outside->normal, Vec3(0, flip ? -1 : 1, 0));
                const auto inside = geometry.intersect({{0, 0, 0}, {0, -1, 0}});
                ASSERT_TRUE(inside);
                EXPECT_EQ(inside->normal, Vec3(0, flip ? 1 : -1, 0));
            }
}

/// Rays that leave inwards meet the other side; those that leave outwards meet nothing.
TEST(Cylinder, does_not_meet_itself) {
    Dice dice(14);
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        const double size = dice.magnitude(-3, 3);
        const Vec3d center = dice.in_box(1) * dice.magnitude(-3, 3);
        const Geometry geometry =
            of_one(Cylinder{}, test::scaling(size, size * dice.magnitude(-1, 1), size) *
                                   test::rotation(dice.direction(), dice.number(0, 6)) *
                                   test::translation(center));
        for (int j = 0; j < 100; ++j) {
            const auto hit =
                geometry.intersect(test::ray_between(center + dice.direction() * size * 3, center));
            if (!hit) continue;
            ++hits;
            const Vec3 out = dice.direction_float();
            const auto next = geometry.intersect(test::leaving(*hit, out));
            EXPECT_FALSE(hit->normal.dot(out) > 0 && next);
            EXPECT_TRUE(!next || next->normal.dot(out) > 0);
        }
    }
    EXPECT_GT(hits, 20000);
}

TEST(Cylinder, lines_along_the_axis_meet_nothing) {
    const Geometry geometry = of_one(Cylinder{});
    EXPECT_FALSE(geometry.intersect({{0.5F, 0, 5}, {0, 0, -1}}));
    EXPECT_FALSE(geometry.intersect({{1, 0, 5}, {0, 0, -1}}));
}

/// An elliptic cylinder's area is its height times the perimeter; 9.6884482205 for half axes 1, 2
/// (4 a E(e), tables).
TEST(Cylinder, areas_are_the_closed_forms) {
    EXPECT_NEAR(surface_area({Cylinder{2, -1, 3, 1.5}, Matrix(), false}), 2 * 4 * 1.5, 1e-12);
    const Matrix turned = test::scaling(3, 3, 0.5) * test::rotation({1, 2, 3}, 0.7);
    EXPECT_NEAR(surface_area({Cylinder{2, -1, 3, 1.5}, turned, false}), 3 * 0.5 * 2 * 4 * 1.5,
                1e-11);
    const Matrix ellipse = test::scaling(1, -2, 3) * test::rotation({1, 2, 3}, 0.7);
    EXPECT_NEAR(surface_area({Cylinder{}, ellipse, false}), 6 * 9.6884482205, 1e-6);
}

}  // namespace
}  // namespace sunfleck::engine
