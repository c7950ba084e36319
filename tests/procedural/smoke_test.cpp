// The smoke: it fills its grid without being cut at the sides, and leaves by none.

#include "procedural/smoke.h"

#include "scene_reading.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sunfleck::engine {
namespace {

TEST(Smoke, is_not_cut_at_the_sides_or_at_the_top) {
    const std::vector<std::string> words = pbrt_words(make_scene("smoke").at(0).bytes);
    const std::vector<float> density = pbrt_numbers(words, 0, "float density");
    constexpr std::size_t kSide = 40;
    constexpr std::size_t kHigh = 64;
    ASSERT_EQ(density.size(), kSide * kSide * kHigh);
    std::size_t filled = 0;
    for (std::size_t i = 0; i < density.size(); ++i) {
        const std::size_t x = i % kSide;
        const std::size_t y = i / kSide % kSide;
        const bool is_outer = x == 0 || x == kSide - 1 || y == 0 || y == kSide - 1;
        if (is_outer || i >= kSide * kSide * (kHigh - 1)) {
            ASSERT_LE(density[i], 1) << i;
        }
        filled += density[i] > 0 ? 1 : 0;
    }
    EXPECT_GT(filled, density.size() / 20);
}

}  // namespace
}  // namespace sunfleck::engine
