// The clear sky: its illuminance, bright around the sun and at the horizon, blue opposite.

#include "procedural/sky.h"

#include "math/warp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace sunfleck::engine {
namespace {

constexpr int kSide = 64;

struct Sky {
    std::string bytes;
    explicit Sky(const Vec3d& sun) : bytes(clear_sky_pfm(sun, kSide)) {}

    std::array<float, 3> texel(int column, int row) const {
        std::array<float, 3> rgb{};
        const std::size_t head = bytes.size() - std::size_t{12} * kSide * kSide;
        const auto at = static_cast<std::size_t>((kSide - 1 - row) * kSide + column);
        std::memcpy(rgb.data(), bytes.data() + head + 12 * at, 12);
        return rgb;
    }
    std::array<float, 3> towards(const Vec3d& w) const {
        const Vec2d u = sphere_to_square(w.normalized());
        const auto cell = [](double x) { return std::min(kSide - 1, static_cast<int>(x * kSide)); };
        return texel(cell(u.x), cell(u.y));
    }
};

float luminance_of(const std::array<float, 3>& rgb) {
    return 0.2126F * rgb[0] + 0.7152F * rgb[1] + 0.0722F * rgb[2];
}

TEST(Sky, gives_an_illuminance_of_one) {
    const Sky sky(Vec3d(-0.6, 0.36, 0.714).normalized());
    double sum = 0;
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column) {
            const Vec3d w = uniform_sphere({(column + 0.5) / kSide, (row + 0.5) / kSide});
            if (w.z > 0) sum += luminance_of(sky.texel(column, row)) * w.z;
        }
    EXPECT_NEAR(sum * 4 * kPiDouble / kSide / kSide, 1, 0.002);
}

TEST(Sky, is_bright_around_the_sun_and_blue_away_from_it) {
    const Sky sky(Vec3d(-0.6, 0, 0.8));
    const auto near = sky.towards({-0.55, 0.05, 0.83});
    const auto opposite = sky.towards({0.6, 0, 0.8});
    EXPECT_GT(luminance_of(near), 3 * luminance_of(opposite));
    EXPECT_GT(opposite[2], 1.5 * opposite[0]);
    const auto horizon = sky.towards({0, 1, 0.15});
    EXPECT_LT(horizon[2] / horizon[0], opposite[2] / opposite[0]) << "whiter at the horizon";
    EXPECT_LT(luminance_of(sky.towards({0, 1, -0.5})), luminance_of(horizon));
}

}  // namespace
}  // namespace sunfleck::engine
