// The two tumblers: indices on the right surfaces, and a drop that stays within the water.

#include "procedural/milk.h"

#include "scene_reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace sunfleck::engine {
namespace {

/// The index of each named material.
std::map<std::string, double> indices(const std::vector<std::string>& words) {
    std::map<std::string, double> found;
    for (std::size_t i = 0; i + 5 < words.size(); ++i)
        if (words[i] == "MakeNamedMaterial" && words[i + 3] == "\"dielectric")
            found[words[i + 1].substr(1)] = std::stod(words[i + 5]);
    return found;
}

TEST(Milk, each_surface_has_the_ratio_of_its_two_media) {
    const std::vector<std::string> words = pbrt_words(make_scene("milk").at(0).bytes);
    const std::map<std::string, double> eta = indices(words);
    EXPECT_NEAR(eta.at("glass"), 1.52, 1e-7);
    EXPECT_NEAR(eta.at("water wall"), 1.333 / 1.52, 1e-7);
    EXPECT_NEAR(eta.at("water level"), 1.333, 1e-7);
    EXPECT_NEAR(eta.at("milk wall"), 1.35 / 1.52, 1e-7);
    EXPECT_NEAR(eta.at("milk level"), 1.35, 1e-7);
}

/// The density's grid ends where there is no milk, but for its top, which is above the level.
TEST(Milk, the_drop_has_no_cut_sides) {
    const std::vector<std::string> words = pbrt_words(make_scene("milk").at(0).bytes);
    const std::vector<float> density = pbrt_numbers(words, 0, "float density");
    constexpr std::size_t kSide = 36;
    ASSERT_EQ(density.size(), kSide * kSide * 52);
    for (std::size_t i = 0; i < density.size(); ++i) {
        const std::size_t x = i % kSide;
        const std::size_t y = i / kSide % kSide;
        const bool is_outer = x == 0 || x == kSide - 1 || y == 0 || y == kSide - 1;
        if (is_outer || i < kSide * kSide) {
            ASSERT_EQ(density[i], 0) << i;
        }
    }
    EXPECT_EQ(*std::max_element(density.begin(), density.end()), 100);
}

}  // namespace
}  // namespace sunfleck::engine
