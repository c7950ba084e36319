// Disks, rings and sectors, traced through Geometry, against closed forms.
#include "geometry/disk.h"

#include "geometry/sweep.h"
#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using test::Dice;
using test::distance;
using test::of_one;

TEST(Disk, is_a_sector_of_a_ring_at_its_height) {
    Dice dice(11);
    for (const double turn : {1.0, 3.0, 5.0, kFullCircle}) {
        const Geometry geometry = of_one(Disk{0.5, 2, 0.75, turn});
        for (int i = 0; i < 5000; ++i) {
            const Ray ray = test::ray_between(dice.direction() * 6, dice.in_box(2));
            const double t = (0.5 - double{ray.origin.z}) / ray.direction.z;
            const Vec3d p = Vec3d(ray.origin) + Vec3d(ray.direction) * t;
            const double r = std::sqrt(p.x * p.x + p.y * p.y);
            const double angle = std::atan2(p.y, p.x) + (p.y < 0 ? kFullCircle : 0);
            const bool there = t > 0 && r < 2 && r > 0.75 && angle < turn;
            const auto hit = geometry.intersect(ray);
            ASSERT_EQ(hit.has_value(), there);
            EXPECT_EQ(geometry.occluded(ray), there);
            if (!hit) continue;
            EXPECT_LT(distance(Vec3d(hit->position), p), 1e-6);
            EXPECT_EQ(hit->normal, Vec3(0, 0, 1));
            EXPECT_NEAR(hit->uv.x, angle / turn, 1e-6);
            EXPECT_NEAR(hit->uv.y, (2 - r) / 1.25, 1e-6);
            EXPECT_LT(distance(Vec3d(hit->tangent), Vec3d(-p.y, p.x, 0) * turn), 1e-5);
        }
    }
}

TEST(Disk, does_not_meet_itself) {
    Dice dice(12);
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        const double size = dice.magnitude(-3, 3);
        const Vec3d center = dice.in_box(1) * dice.magnitude(-3, 3);
        const Geometry geometry =
            of_one(Disk{}, test::scaling(size, size * dice.magnitude(-1, 1), size) *
                               test::rotation(dice.direction(), dice.number(0, 6)) *
                               test::translation(center));
        for (int j = 0; j < 100; ++j) {
            const auto hit =
                geometry.intersect(test::ray_between(center + dice.direction() * size * 3, center));
            if (!hit) continue;
            ++hits;
            EXPECT_FALSE(geometry.intersect(test::leaving(*hit, dice.direction_float())));
        }
    }
    EXPECT_GT(hits, 20000);
}

TEST(Disk, an_edge_on_ray_hits_nothing) {
    const Geometry geometry = of_one(Disk{});
    EXPECT_FALSE(geometry.intersect({{-5, 0, 0}, {1, 0, 0}}));
    const auto middle = geometry.intersect({{0, 0, 5}, {0, 0, -1}});
    ASSERT_TRUE(middle);
    EXPECT_GT(middle->tangent.length(), 0);
    EXPECT_TRUE(std::isfinite(middle->uv.x) && std::isfinite(middle->uv.y));
}

}  // namespace
}  // namespace sunfleck::engine
