// Spheres and their parts, traced through Geometry, against closed forms.
#include "geometry/sphere.h"

#include "geometry/sweep.h"
#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using test::Dice;
using test::distance;
using test::of_one;
using test::ray_between;

TEST(Sphere, hits_are_where_the_quadratic_equation_has_them) {
    Dice dice(7);
    const Vec3d center(3, -2, 5);
    const Geometry geometry = of_one(Sphere{2, -2, 2, kFullCircle}, test::translation(center));
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const Ray ray = ray_between(center + dice.direction() * 5, center + dice.in_box(2.2));
        const Vec3d o = Vec3d(ray.origin) - center;
        const Vec3d d(ray.direction);
        const double b = o.dot(d) / d.dot(d);
        const double discriminant = b * b - (o.dot(o) - 4) / d.dot(d);
        const auto hit = geometry.intersect(ray);
        if (std::abs(discriminant) < 1e-6) continue;
        ASSERT_EQ(hit.has_value(), discriminant > 0);
        EXPECT_EQ(geometry.occluded(ray), discriminant > 0);
        if (!hit) continue;
        ++hits;
        const double t = -b - std::sqrt(discriminant);
        EXPECT_NEAR(hit->distance, t, 1e-6);
        EXPECT_LT(distance(Vec3d(hit->position), Vec3d(ray.origin) + d * t), 1e-6);
        const Vec3d outwards = (Vec3d(hit->position) - center) / 2;
        EXPECT_LT(distance(Vec3d(hit->normal), outwards), 1e-6);
        EXPECT_EQ(hit->normal, hit->shading_normal);
    }
    EXPECT_GT(hits, 10000);
}

TEST(Sphere, from_inside_the_far_side_is_hit) {
    Dice dice(8);
    const Geometry geometry = of_one(Sphere{});
    for (int i = 0; i < 1000; ++i) {
        const auto hit = geometry.intersect({Vec3(dice.in_box(0.5)), dice.direction_float()});
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->position.length(), 1, 1e-6);
        EXPECT_LT(distance(Vec3d(hit->normal), Vec3d(hit->position)), 1e-6);
    }
}

/// Leaving outwards a sphere is never met again; leaving inwards it is, a chord away.
TEST(Sphere, does_not_meet_itself) {
    Dice dice(9);
    for (int i = 0; i < 300; ++i) {
        const double radius = dice.magnitude(-2, 3);
        const Vec3d center = dice.in_box(1) * radius * dice.magnitude(-2, 2);
        const Geometry geometry =
            of_one(Sphere{radius, -radius, radius, kFullCircle},
                   test::rotation(dice.direction(), dice.number(0, 6)) * test::translation(center));
        for (int j = 0; j < 100; ++j) {
            const auto hit = geometry.intersect(
                ray_between(center + dice.direction() * radius * 3, center + dice.in_box(radius)));
            if (!hit) continue;
            const Vec3 out = dice.direction_float();
            const auto again = geometry.intersect(test::leaving(*hit, out));
            const double cosine = Vec3d(hit->normal).dot(Vec3d(out));
            EXPECT_EQ(again.has_value(), cosine < 0) << radius << " " << center << " " << cosine;
            if (!again || cosine > -0.01) continue;
            EXPECT_NEAR(again->distance, -2 * radius * cosine, 1e-3 * radius);
        }
    }
}

TEST(Sphere, parts_are_cut_by_height_and_azimuth) {
    Dice dice(10);
    for (const double turn : {0.5, 2.0, 4.0, kFullCircle}) {
        const Sphere part{1, -0.3, 0.7, turn};
        const Geometry geometry = of_one(part);
        const auto is_there = [&](const Vec3d& p) {
            double angle = std::atan2(p.y, p.x);
            if (angle < 0) angle += kFullCircle;
            return p.z > -0.3 && p.z < 0.7 && angle < turn;
        };
        for (int i = 0; i < 5000; ++i) {
            const Ray ray = ray_between(dice.direction() * 3, dice.in_box(0.9));
            const Crossings all = Sphere{}.crossings(Vec3d(ray.origin), Vec3d(ray.direction));
            if (!all.on[0]) continue;
            const Vec3d first = Vec3d(ray.origin) + Vec3d(ray.direction) * all.t[0];
            const Vec3d second = Vec3d(ray.origin) + Vec3d(ray.direction) * all.t[1];
            const auto hit = geometry.intersect(ray);
            ASSERT_EQ(hit.has_value(), is_there(first) || is_there(second));
            if (!hit) continue;
            EXPECT_LT(distance(Vec3d(hit->position), is_there(first) ? first : second), 1e-6);
        }
    }
}

TEST(Sphere, coordinates_and_tangent_are_those_of_pbrt) {
    const Geometry whole = of_one(Sphere{});
    const auto hit = whole.intersect({{0, 5, 0}, {0, -1, 0}});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->uv.x, 0.25, 1e-6);
    EXPECT_NEAR(hit->uv.y, 0.5, 1e-6);
    EXPECT_LT(distance(Vec3d(hit->tangent), Vec3d(-2 * kPiDouble, 0, 0)), 1e-5);
    const Geometry part = of_one(Sphere{1, -1, 0.5, kPiDouble});
    const auto low = part.intersect({{0, 0.6F, 5}, {0, 0, -1}});  // passes the hole at the top
    ASSERT_TRUE(low);
    EXPECT_NEAR(low->position.z, -0.8, 1e-6);
    EXPECT_NEAR(low->uv.x, 0.5, 1e-6);
    EXPECT_NEAR(low->uv.y, (kPi - std::acos(-0.8)) / (kPi - std::acos(0.5)), 1e-6);
    const auto pole = whole.intersect({{0, 0, 5}, {0, 0, -1}});
    ASSERT_TRUE(pole);
    EXPECT_GT(pole->tangent.length(), 0);
    EXPECT_NEAR(pole->uv.y, 1, 1e-6);
}

TEST(Sphere, grazing_far_and_tiny_spheres_give_finite_hits) {
    const Geometry tiny = of_one(Sphere{1e-4, -1e-4, 1e-4, kFullCircle});
    const auto hit = tiny.intersect({{0, 0, 1000}, {0, 0, -1}});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->position.z, 1e-4, 1e-10);
    const auto grazing = of_one(Sphere{}).intersect({{1, -5, 0}, {0, 1, 0}});
    if (grazing) {
        EXPECT_TRUE(std::isfinite(grazing->normal.length()));
    }
}

}  // namespace
}  // namespace sunfleck::engine
