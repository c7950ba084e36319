// Glare: no light is lost, an even picture stays even, and a point spreads by the stated law.
#include "image/glare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace sunfleck::engine {
namespace {

std::vector<float> point_at(const Vec2i& size, int x, int y, float light) {
    std::vector<float> pixels(static_cast<std::size_t>(size.x * size.y));
    pixels[static_cast<std::size_t>(y * size.x + x)] = light;
    return pixels;
}

double total(const std::vector<float>& light) {
    return std::accumulate(light.begin(), light.end(), 0.0);
}

TEST(Glare, no_light_is_lost_wherever_it_is) {
    for (const Vec2i& size : {Vec2i(64, 48), Vec2i(3, 50), Vec2i(1, 1), Vec2i(7, 1)})
        for (const auto& [x, y] : {std::pair{0, 0}, {size.x - 1, size.y / 2}}) {
            std::vector<float> light = point_at(size, x, y, 1e6F);
            add_glare(light, size, 0.3);
            EXPECT_NEAR(total(light), 1e6, 1) << size.x << "x" << size.y;
            for (const float value : light) EXPECT_GE(value, 0);
        }
}

TEST(Glare, an_even_picture_stays_even) {
    const Vec2i size(40, 30);
    std::vector<float> light(1200, 2.5F);
    add_glare(light, size, 0.5);
    for (const float value : light) EXPECT_NEAR(value, 2.5F, 1e-5F);
}

TEST(Glare, a_fraction_of_nothing_changes_nothing) {
    std::vector<float> light = point_at({30, 30}, 4, 5, 3);
    const std::vector<float> before = light;
    add_glare(light, {30, 30}, 0);
    EXPECT_EQ(light, before);
}

/// 1/t^3 + 1/t^2, t in degrees, where 400 pixels are 40 degrees: within 12% from .5 to 6 degrees,
/// along an axis and along a diagonal. A single Gaussian would be off by orders of magnitude.
TEST(Glare, falls_with_the_angle_as_it_is_stated) {
    const Vec2i size(400, 400);
    std::vector<float> light = point_at(size, 200, 200, 1e6F);
    add_glare(light, size, 1);
    const auto at = [&](int dx, int dy) {
        const double degrees = 0.1 * std::hypot(dx, dy);
        const double law = 1 / (degrees * degrees * degrees) + 1 / (degrees * degrees);
        return light[static_cast<std::size_t>((200 + dy) * size.x + 200 + dx)] / law;
    };
    const double one = at(10, 0);
    for (const int pixels : {5, 7, 15, 20, 30, 40, 60}) {
        EXPECT_NEAR(at(pixels, 0) / one, 1, 0.12) << pixels;
        EXPECT_NEAR(at(0, -pixels) / one, 1, 0.12) << pixels;
    }
    for (const int pixels : {4, 7, 14, 28, 42})
        EXPECT_NEAR(at(pixels, pixels) / one, 1, 0.12) << pixels;
}

/// Twice as many pixels of the same view: the same light around the point.
TEST(Glare, does_not_depend_on_the_resolution) {
    std::vector<float> coarse = point_at({100, 100}, 50, 50, 4);
    std::vector<float> fine(40'000);
    for (const std::size_t i : {100 * 200 + 100, 100 * 200 + 101, 101 * 200 + 100, 101 * 200 + 101})
        fine[i] = 4;
    add_glare(coarse, {100, 100}, 0.2);
    add_glare(fine, {200, 200}, 0.2);
    const double there = fine[100 * 200 + 120] + fine[100 * 200 + 121] + fine[101 * 200 + 120] +
                         fine[101 * 200 + 121];
    EXPECT_NEAR(there / (4 * coarse[50 * 100 + 60]), 1, 0.05);
}

}  // namespace
}  // namespace sunfleck::engine
