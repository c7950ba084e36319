// The maps from the square: on their target, uniform there, continuous, gentle, exact in double.
//
// Uniformity: chi-square at significance 1e-3 a map over 2^18 jittered points in 16 x 16 cells of
// a coordinate system made for it; it sees a density off by 2% over half the target.
#include "math/warp.h"

#include "core/random.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace sunfleck::engine {
namespace {

using testing_support::chi_square_p;

constexpr int kSide = 16;

/// Share of a turn of the azimuth, in [0,1).
double azimuth(double x, double y) {
    const double turn = std::atan2(y, x) / (2 * kPiDouble);
    return turn < 0 ? turn + 1 : turn;
}

/// p of the hypothesis that `coordinates` of the mapped points are uniform in the unit square.
double uniformity(const std::function<Vec2d(const Vec2d&)>& coordinates) {
    std::vector<int> count(kSide * kSide, 0);
    RandomStream random(7, Purpose::test, 0, 0);
    constexpr int kSamples = 1 << 18;
    for (int i = 0; i < kSamples; ++i) {
        const double x = random.next();
        const Vec2d c = coordinates({x, random.next()});
        const int column = std::clamp(static_cast<int>(c.x * kSide), 0, kSide - 1);
        const int row = std::clamp(static_cast<int>(c.y * kSide), 0, kSide - 1);
        ++count.at(static_cast<std::size_t>(row * kSide + column));
    }
    const double expected = static_cast<double>(kSamples) / (kSide * kSide);
    double statistic = 0;
    for (const int n : count) statistic += (n - expected) * (n - expected) / expected;
    return chi_square_p(statistic, kSide * kSide - 1);
}

TEST(Warp, concentric_disc_is_uniform) {
    EXPECT_GT(uniformity([](const Vec2d& u) {
                  const Vec2d p = concentric_disc(u);
                  return Vec2d(p.length2(), azimuth(p.x, p.y));
              }),
              1e-3);
}

TEST(Warp, uniform_sphere_is_uniform) {
    EXPECT_GT(uniformity([](const Vec2d& u) {
                  const Vec3d p = uniform_sphere(u);
                  EXPECT_NEAR(p.length2(), 1, 1e-14);
                  return Vec2d((p.z + 1) / 2, azimuth(p.x, p.y));
              }),
              1e-3);
}

TEST(Warp, sphere_to_square_goes_back) {
    for (int y = 0; y <= 100; ++y)
        for (int x = 0; x <= 100; ++x) {
            const Vec2d u(0.01 * x, 0.01 * y);
            const Vec3d w = uniform_sphere(u);
            const Vec3d again = uniform_sphere(sphere_to_square(w));
            ASSERT_LT((again - w).length(), 1e-6) << u;
            const bool inside = std::min({u.x, u.y, 1 - u.x, 1 - u.y}) > 0;  // edges are folded
            ASSERT_LT(inside ? (sphere_to_square(w) - u).length() : 0, 1e-6) << u;
        }
}

TEST(Warp, cosine_hemisphere_has_density_cosine) {
    EXPECT_GT(uniformity([](const Vec2d& u) {
                  const Vec3d p = cosine_hemisphere(u);
                  EXPECT_NEAR(p.length2(), 1, 1e-14);
                  EXPECT_GE(p.z, 0);
                  return Vec2d(p.z * p.z, azimuth(p.x, p.y));
              }),
              1e-3);
}

/// Uniform in the cone around +z whose 1 - cos of the half angle is `versine`.
Vec3d in_cone(const Vec2d& u, double versine) {
    const DiscPoint disc = concentric_disc_point(u);
    return around_pole(disc, disc.radius2 * versine);
}

TEST(Warp, directions_around_the_pole_are_uniform_in_a_cone) {
    for (const double versine : {1e-12, 0.3, 1.0, 2.0})
        EXPECT_GT(uniformity([=](const Vec2d& u) {
                      const Vec3d p = in_cone(u, versine);
                      const double flat2 = p.x * p.x + p.y * p.y;
                      const double own = p.z > 0 ? flat2 / (1 + p.z) : 1 - p.z;  // 1 - cos
                      return Vec2d(own / versine, azimuth(p.x, p.y));
                  }),
                  1e-3)
            << versine;
}

TEST(Warp, uniform_triangle_is_uniform) {
    EXPECT_GT(uniformity([](const Vec2d& u) {
                  const Vec2d w = uniform_triangle(u);
                  EXPECT_TRUE(w.x >= 0 && w.y >= 0 && w.x + w.y <= 1);
                  // x + y of a triangle's point has the CDF s^2; along the diagonal it is even.
                  const double s = w.x + w.y;
                  return Vec2d(s * s, w.y / s);
              }),
              1e-3);
}

struct Map {
    const char* name;
    std::function<Vec3d(const Vec2d&)> map;
    double steepest;  // largest allowed move over a move of u
};

/// The steepest slopes that warp.h promises, everywhere, seams of the formulas included.
TEST(Warp, no_map_jumps_or_is_steep) {
    const auto flat = [](const Vec2d& p) { return Vec3d(p.x, p.y, 0); };
    const auto height2 = [](const Vec3d& p) { return Vec3d(p.x, p.y, p.z * p.z); };
    const std::vector<Map> maps = {
        {"disc", [=](const Vec2d& u) { return flat(concentric_disc(u)); }, 2.8},
        {"sphere", [](const Vec2d& u) { return uniform_sphere(u); }, 6.2},
        {"cone", [](const Vec2d& u) { return in_cone(u, 1); }, 4.4},
        {"cosine", [=](const Vec2d& u) { return height2(cosine_hemisphere(u)); }, 4.8},
        {"triangle", [=](const Vec2d& u) { return flat(uniform_triangle(u)); }, 1.2}};
    constexpr double kStep = 1e-6;
    RandomStream random(8, Purpose::test, 0, 0);
    for (const Map& m : maps)
        for (int i = 0; i < 100000; ++i) {
            Vec2d u(random.next(), random.next());
            // A third of the points lie on the lines where the formulas change.
            if (i % 6 == 0) u.y = u.x;
            if (i % 6 == 1) u.x = 0.5;
            const SinCos way = sin_cos_2pi(random.next());
            const Vec2d step = Vec2d(way.cos, way.sin) * kStep;
            ASSERT_LE((m.map(u + step) - m.map(u)).length(), m.steepest * kStep)
                << m.name << " at " << u;
        }
}

TEST(Warp, corners_and_middle_stay_on_target) {
    for (const double x : {0.0, 0x1p-53, 0.25, 0.5, 1 - 0x1p-53, 1.0})
        for (const double y : {0.0, 0x1p-53, 0.5, 0.75, 1.0}) {
            EXPECT_LE(concentric_disc({x, y}).length(), 1 + 1e-15);
            EXPECT_NEAR(uniform_sphere({x, y}).length(), 1, 1e-14) << x << " " << y;
            EXPECT_NEAR(cosine_hemisphere({x, y}).length(), 1, 1e-14);
            EXPECT_NEAR(in_cone({x, y}, 0.5).length(), 1, 1e-14);
        }
}

TEST(Warp, rotation_takes_z_to_the_axis_and_keeps_angles) {
    RandomStream random(9, Purpose::test, 0, 0);
    const auto direction = [&] { return uniform_sphere({random.next(), random.next()}); };
    std::vector<Vec3d> axes = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
    for (const double tilt : {1e-3, 1e-7, 1e-9, 1e-12})
        axes.emplace_back(tilt, tilt, -std::sqrt(1 - 2 * tilt * tilt));
    for (int i = 0; i < 1000; ++i) axes.push_back(direction());
    for (const Vec3d& axis : axes) {
        const Vec3d a = direction();
        const Vec3d b = direction();
        EXPECT_NEAR((rotate_z_to(axis, {0, 0, 1}) - axis).length(), 0, 1e-15);
        EXPECT_NEAR(rotate_z_to(axis, a).dot(rotate_z_to(axis, b)), a.dot(b), 3e-15) << axis;
        const Vec3d turned = rotate_z_to(axis, a).cross(rotate_z_to(axis, b));
        EXPECT_NEAR((turned - rotate_z_to(axis, a.cross(b))).length(), 0, 5e-15) << axis;
    }
}

}  // namespace
}  // namespace sunfleck::engine
