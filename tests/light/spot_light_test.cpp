// The spot's falloff, its inverse square, and directions drawn exactly from the smooth edge.
#include "light/spot_light.h"

#include "core/random.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <vector>

namespace sunfleck::engine {
namespace {

SpotLight spot(double cos_start, double cos_total, SpotEdge edge = SpotEdge::smoothstep) {
    SpotLight light;
    light.edge = edge;
    light.position = Vec3d(1, 2, 3);
    light.axis = Vec3d(0, 0, -1);
    light.cos_start = cos_start;
    light.cos_total = cos_total;
    return light;
}

TEST(SpotLight, falloff_is_the_smoothstep_of_the_cosine) {
    const SpotLight light = spot(0.9, 0.5);
    EXPECT_EQ(light.falloff(1), 1);
    EXPECT_EQ(light.falloff(0.9), 1);
    EXPECT_NEAR(light.falloff(0.7), 0.5, 1e-15);
    EXPECT_NEAR(light.falloff(0.6), 0.0625 * 2.5, 1e-15);
    EXPECT_EQ(light.falloff(0.5), 0);
    EXPECT_EQ(light.falloff(-1), 0);
    EXPECT_EQ(spot(0.5, 0.5).falloff(0.5), 1);
}

/// The formula that KHR_lights_punctual recommends.
TEST(SpotLight, falloff_may_be_the_square_of_the_cosine) {
    const double inner = 0.3;
    const double outer = 0.8;
    const SpotLight light = spot(std::cos(inner), std::cos(outer), SpotEdge::square);
    const double scale = 1 / std::max(0.001, std::cos(inner) - std::cos(outer));
    const double offset = -std::cos(outer) * scale;
    for (double angle = 0; angle < 1.2; angle += 0.05) {
        const double root = std::clamp(std::cos(angle) * scale + offset, 0.0, 1.0);
        EXPECT_NEAR(light.falloff(std::cos(angle)), root * root, 1e-14) << angle;
    }
}

TEST(SpotLight, irradiance_is_intensity_over_distance_squared) {
    const SpotLight light = spot(0.9, 0.5);
    const auto on_axis = light.sample_direct({1, 2, 1}, {.5, .5}, {});
    ASSERT_TRUE(on_axis);
    EXPECT_FLOAT_EQ(on_axis->factor, 0.25F);
    EXPECT_FLOAT_EQ(on_axis->distance, 2);
    EXPECT_EQ(on_axis->direction, Vec3(0, 0, 1));
    EXPECT_FALSE(on_axis->pdf);
    const auto aside = light.sample_direct({2, 2, 2}, {.5, .5}, {});  // 45 degrees
    ASSERT_TRUE(aside);
    const double t = (std::sqrt(0.5) - 0.5) / 0.4;
    EXPECT_NEAR(aside->factor, t * t * (3 - 2 * t) / 2, 1e-6);
    EXPECT_FALSE(light.sample_direct({3, 2, 2}, {.5, .5}, {}));  // outside the cone
    EXPECT_FALSE(light.sample_direct({1, 2, 4}, {.5, .5}, {}));  // behind
    EXPECT_FALSE(light.sample_direct({1, 2, 3}, {.5, .5}, {}));  // in the light itself
}

TEST(SpotLight, power_is_the_integral_of_the_falloff) {
    for (const SpotEdge edge : {SpotEdge::smoothstep, SpotEdge::square})
        for (const auto& [start, total] :
             {std::pair(0.9, 0.5), {1.0, -0.3}, {0.6, 0.6}, {1.0, 0.999}}) {
            const SpotLight light = spot(start, total, edge);
            constexpr int kCells = 1 << 20;
            double sum = 0;
            for (int i = 0; i < kCells; ++i) sum += light.falloff(2 * (i + 0.5) / kCells - 1);
            const double integral = sum * 2 / kCells * 2 * kPiDouble;
            EXPECT_NEAR(light.power({}) / integral, 1, 2e-4) << start << " " << total;
        }
}

/// The share of photons inside each cosine is the integral of the falloff: to rounding, not noise.
/// Along a line of dimensions from the middle, the disc's radius squared is that share.
/// @param outside  the integral of the falloff from the rim to t, for an edge of width one.
template <class Integral>
void expect_exact_quantiles(SpotEdge kind, const Integral& outside) {
    for (const auto& [start, total] :
         {std::pair(0.9, 0.5), {1.0, -0.3}, {0.6, 0.6}, {1.0, 0.999}, {0.99999, 0.99998}}) {
        const SpotLight light = spot(start, total, kind);
        const double edge = start - total;
        for (int i = 1; i < 4000; ++i) {
            const double r = i / 4000.0;
            const Emission e = light.sample_emission({0.1, 0.2, (1 + r) / 2, 0.5}, {});
            const double c = -e.direction.z;
            const double t = edge > 0 ? std::min((c - total) / edge, 1.0) : 1;
            const double whole = edge * outside(1.0);
            const double inside = 1 - start + whole - edge * outside(t);
            const double share = (c >= start ? 1 - c : inside) / (1 - start + whole);
            // One unit in the last place of the cosine is 1e-16 / edge of the share.
            ASSERT_NEAR(share, r * r, 1e-14 + 1e-15 / (1 - total)) << start << " " << total;
            EXPECT_EQ(e.factor, light.power({}));
            EXPECT_EQ(e.origin, light.position);
        }
    }
}

TEST(SpotLight, directions_are_exact_quantiles) {
    expect_exact_quantiles(SpotEdge::smoothstep,
                           [](double t) { return t * t * t - t * t * t * t / 2; });
}

/// Dimensions that end near the rim of the cone: the quartic's root to the last of its digits.
TEST(SpotLight, the_rim_is_reached_and_never_passed) {
    const SpotLight light = spot(0.9, 0.5);
    for (int power = 2; power <= 52; ++power) {
        const double gap = std::ldexp(1.0, -power);
        const Emission e = light.sample_emission({0.5, 0.5, 1 - gap / 2, 0.5}, {});
        const double outside = gap * (2 - gap) * 0.3;  // 1 - r^2, in units of flux / (2 pi)
        // Near the rim the share outside is edge * t^3: t is its cube root.
        const double t = (-e.direction.z - 0.5) / 0.4;
        EXPECT_GE(t, -3e-16);
        EXPECT_NEAR(t * t * t - t * t * t * t / 2, outside / 0.4, 1e-15 + 1e-9 * outside) << gap;
    }
}

TEST(SpotLight, directions_are_exact_quantiles_of_the_square) {
    expect_exact_quantiles(SpotEdge::square, [](double t) { return t * t * t / 3; });
}

TEST(SpotLight, directions_move_gently_with_their_dimensions) {
    const SpotLight light = spot(0.9, 0.5);
    RandomStream random(11, Purpose::test, 0, 0);
    constexpr double kStep = 1e-7;
    for (int i = 0; i < 100000; ++i) {
        const Vec2d u(random.next(), random.next());
        // The rim alone is steep: there t is a cube root.
        if (std::max(std::abs(u.x - 0.5), std::abs(u.y - 0.5)) > 0.49) continue;
        const Vec3d here = light.sample_emission({0, 0, u.x, u.y}, {}).direction;
        const Vec3d there = light.sample_emission({0, 0, u.x + kStep, u.y}, {}).direction;
        ASSERT_LT((there - here).length(), 8 * kStep) << u;
    }
}

}  // namespace
}  // namespace sunfleck::engine
