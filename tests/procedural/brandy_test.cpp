// The scene brandy: leaves that leave a gap, and the indices of its surfaces.

#include "procedural/brandy.h"

#include "core/random.h"
#include "media_checks.h"
#include "procedural/leaves.h"
#include "scene_reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Where the sun falls on the glass through the middle of the gap no leaf is in its way.
TEST(Brandy, the_gap_of_the_leaves_is_free) {
    const Vec3d sun = Vec3d(0.748, 0.664, 0.92).normalized();
    const Mesh leaves = canopy({.sun = sun, .place = {-3, -3, 3}});
    EXPECT_EQ(leaves.triangles.size(), 1500 * 18);
    RandomStream random(4, Purpose::test, 0, 0);
    for (int i = 0; i < 50; ++i) {
        const Vec3d from(-3 + 10 * random.next() - 5, -3 + 10 * random.next() - 5, 3);
        EXPECT_TRUE(all_hits(leaves, from, sun).empty());
    }
    EXPECT_FALSE(all_hits(leaves, {9, 20, 0}, sun).empty() &&
                 all_hits(leaves, {-20, 14, 0}, sun).empty() &&
                 all_hits(leaves, {12, -16, 0}, sun).empty());
}

/// Values of a spectrum that precedes the mesh of a file.
std::vector<float> eta_table(const std::vector<std::string>& words, const std::string& file) {
    const auto shape = std::find(words.begin(), words.end(), "\"" + file);
    const auto material = std::find(std::make_reverse_iterator(shape), words.rend(), "Material");
    return pbrt_numbers(words, static_cast<std::size_t>(words.rend() - material) - 1,
                        "spectrum eta");
}

TEST(Brandy, each_surface_has_the_ratio_of_its_two_media_at_each_wavelength) {
    const std::vector<std::string> words = pbrt_words(brandy_scene().at(0).bytes);
    EXPECT_NEAR(eta_of(words, "geometry/snifter-air.ply"), kSnifterIndex, 1e-7);
    const std::vector<float> level = eta_table(words, "geometry/brandy-level.ply");
    const std::vector<float> wall = eta_table(words, "geometry/brandy-snifter.ply");
    ASSERT_EQ(level.size(), 96);
    ASSERT_EQ(wall.size(), 96);
    for (std::size_t i = 0; i < level.size(); i += 2) {
        EXPECT_EQ(level[i], wall[i]);
        EXPECT_NEAR(level[i + 1], brandy_index(level[i] / 1000.0), 1e-5);
        EXPECT_NEAR(wall[i + 1] * kSnifterIndex, level[i + 1], 2e-5);
    }
    EXPECT_NEAR(brandy_index(0.5893), 1.3555, 1e-4);  // 40% of ethanol in water, sodium light
}

}  // namespace
}  // namespace sunfleck::engine
