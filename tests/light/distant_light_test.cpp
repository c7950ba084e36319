// Point, distant and infinite lights in closed form; emission guides in a world of 10 km.
#include "light/distant_light.h"

#include "core/random.h"
#include "light/area_light.h"
#include "light/infinite_light.h"
#include "light/point_light.h"
#include "math/warp.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

const SceneSphere kFarWorld = {Vec3d(300, -2000, 40), 10000};

TEST(PointLight, irradiance_falls_with_distance_squared) {
    const PointLight light{{}, Vec3d(1, 2, 3)};
    for (const float d : {0.01F, 1.0F, 250.0F}) {
        const auto s = light.sample_direct({1, 2 + d, 3}, {.5F, .5F}, {});
        ASSERT_TRUE(s);
        EXPECT_NEAR(s->factor * d * d, 1, 1e-4);
        EXPECT_NEAR(s->distance / d, 1, 1e-4);
        EXPECT_LT((s->direction - Vec3(0, -1, 0)).length(), 1e-6);
        EXPECT_FALSE(s->pdf);
    }
    EXPECT_FALSE(light.sample_direct({1, 2, 3}, {.5F, .5F}, {}));
    EXPECT_EQ(light.power({}), 4 * kPiDouble);
}

TEST(DistantLight, starts_before_the_scene_and_aims_at_it) {
    const DistantLight light{{}, Vec3d(2, -1, -3).normalized()};
    RandomStream random(12, Purpose::test, 0, 0);
    double widest = 0;
    for (int i = 0; i < 1000; ++i) {
        const Emission e =
            light.sample_emission({random.next(), random.next(), 0.5, 0.5}, kFarWorld);
        EXPECT_EQ(e.direction, light.direction);
        const Vec3d from_center = e.origin - kFarWorld.center;
        ASSERT_NEAR(from_center.dot(light.direction), -kFarWorld.radius, 1e-8);
        const double aside = from_center.cross(light.direction).length();
        ASSERT_LE(aside, kFarWorld.radius * (1 + 1e-14));
        widest = std::max(widest, aside);
    }
    EXPECT_GT(widest, 0.99 * kFarWorld.radius);
    const auto s = light.sample_direct({5, 5, 5}, {.5F, .5F}, kFarWorld);
    ASSERT_TRUE(s);
    EXPECT_EQ(s->direction, Vec3(-light.direction));
    EXPECT_EQ(s->distance, kInfinity);
    EXPECT_EQ(s->factor, 1);
    EXPECT_FALSE(s->pdf);
    EXPECT_DOUBLE_EQ(light.power(kFarWorld), kPiDouble * 1e8);
}

TEST(InfiniteLight, irradiance_is_pi_in_the_open) {
    const InfiniteLight light;
    constexpr int kSide = 256;
    double sum = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const Vec2 u((static_cast<float>(x) + 0.5F) / kSide,
                         (static_cast<float>(y) + 0.5F) / kSide);
            const auto s = light.sample_direct({0, 0, 0}, u, kFarWorld);
            sum += static_cast<double>(s->factor * std::max(0.0F, s->direction.y));
        }
    EXPECT_NEAR(sum / (kSide * kSide), kPiDouble, 3e-4);
}

/// concentric_disc() backwards.
Vec2d disc_dimensions(const Vec2d& p) {
    const double eighth = kPiDouble / 4;
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const double far = std::copysign(p.length(), wide ? p.x : p.y);
    const double near = far * std::atan(wide ? p.y / p.x : p.x / p.y) / eighth;
    return (Vec2d(wide ? far : near, wide ? near : far) + Vec2d(1)) * 0.5;
}

struct Target {
    Vec3d center;
    double radius;
};

/// Irradiance of the target's cross-section, from a square of dimensions that aims at it:
/// midpoints, no randomness. @param side  of the square, in dimensions.
template <class Light>
double aimed_irradiance(const Light& light, const Target& target, const Vec2d& dimensions,
                        double side) {
    constexpr int kSide = 1500;
    double sum = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const Vec2d off((x + 0.5) / kSide - 0.5, (y + 0.5) / kSide - 0.5);
            const Vec2d u = dimensions + off * side;
            const Emission e = light.sample_emission({u.x, u.y, 0.6, 0.8}, kFarWorld);
            const Vec3d to_target = target.center - e.origin;
            const double aside2 = to_target.cross(e.direction).length2();
            if (aside2 < target.radius * target.radius) sum += e.factor;
        }
    const double per_dimension = side * side / (kSide * kSide);
    return sum * per_dimension / (kPiDouble * target.radius * target.radius);
}

/// A target of 1 mm in a world of 10 km gets 4e-15 of the photons, and gets them right.
TEST(DistantLight, hits_a_millimetre_from_ten_kilometres) {
    const DistantLight light{{}, Vec3d(2, -1, -3).normalized()};
    for (const Vec3d& center : {Vec3d(12.3, -45.6, 7), Vec3d(-5000, 3000, 200)}) {
        const Vec3d aside = center - kFarWorld.center;
        const Vec3d x = rotate_z_to(light.direction, {1, 0, 0});
        const Vec3d y = rotate_z_to(light.direction, {0, 1, 0});
        const Vec2d dimensions =
            disc_dimensions(Vec2d(aside.dot(x), aside.dot(y)) / kFarWorld.radius);
        const double got = aimed_irradiance(light, {center, 5e-4}, dimensions, 2e-7);
        EXPECT_NEAR(got, 1, 1e-3) << center;
    }
}

TEST(InfiniteLight, hits_a_millimetre_from_ten_kilometres) {
    const InfiniteLight light;
    const Vec3d direction = light.sample_emission({0.5, 0.5, 0.6, 0.8}, kFarWorld).direction;
    const Vec3d center(12.3, -45.6, 7);
    const Vec3d aside = center - kFarWorld.center;
    const Vec3d x = rotate_z_to(direction, {1, 0, 0});
    const Vec3d y = rotate_z_to(direction, {0, 1, 0});
    const Vec2d dimensions = disc_dimensions(Vec2d(aside.dot(x), aside.dot(y)) / kFarWorld.radius);
    // Radiance one over the whole sphere of directions, of which one is looked at.
    EXPECT_NEAR(aimed_irradiance(light, {center, 5e-4}, dimensions, 2e-7), 4 * kPiDouble,
                0.004 * kPiDouble);
}

/// Neighbouring dimensions (2^-50 apart) give neighbouring positions, evenly, far below a
/// micrometre.
TEST(DistantLight, positions_are_resolved_far_below_a_micrometre) {
    const DistantLight light{{}, Vec3d(2, -1, -3).normalized()};
    const auto origin = [&](double u) {
        return light.sample_emission({u, 0.8, 0.5, 0.5}, kFarWorld).origin;
    };
    const double u = 0.61;
    const Vec3d slope = (origin(u + 1e-4) - origin(u - 1e-4)) / 2e-4;
    for (int i = -200; i <= 200; ++i) {
        const double step = i * 0x1p-50;
        EXPECT_LT((origin(u + step) - origin(u) - slope * step).length(), 2e-11);
    }
}

TEST(AreaLight, ground_of_ten_kilometres_covers_a_millimetre_evenly) {
    AreaLight light;
    light.surface = EmittingTriangle{Vec3d(-7000, -5000, 0), Vec3d(20000, 0, 0), Vec3d(0, 20000, 0),
                                     Vec3d(0, 0, 1)};
    const Vec3d base = light.sample_emission({0.37, 0.2, 0.5, 0.5}, {}).origin;
    for (int i = 1; i <= 200; ++i) {
        const double step = i * 0x1p-50;
        const Vec3d moved = light.sample_emission({0.37 + step, 0.2, 0.5, 0.5}, {}).origin;
        EXPECT_LT((moved - base - Vec3d(20000, 0, 0) * step).length(), 2e-11);
    }
}

}  // namespace
}  // namespace sunfleck::engine
