// The Cornell box: the light faces down, the blocks are closed, the spectra are whole.

#include "procedural/cornell.h"

#include "mesh_checks.h"
#include "scene_reading.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kLight = 0;
constexpr std::size_t kShort = 6;
constexpr std::size_t kTall = 7;

TEST(Cornell, the_light_faces_down_just_below_the_ceiling) {
    const Mesh light = scene_meshes(cornell_scene()).at(kLight);
    double area = 0;
    for (const auto& t : light.triangles) {
        const Vec3d a = area_vector(light, t);
        EXPECT_LT(a.y, 0);
        EXPECT_EQ(a.length(), -a.y);
        area -= a.y;
    }
    EXPECT_DOUBLE_EQ(area, 130 * 105);
    EXPECT_LT(light.points[0][1], 548.8F);
}

TEST(Cornell, the_blocks_are_closed_prisms) {
    const std::vector<Mesh> meshes = scene_meshes(cornell_scene());
    ASSERT_EQ(meshes.size(), 8);
    for (const std::size_t block : {kShort, kTall}) EXPECT_TRUE(open_edges(meshes[block]).empty());
    // Base area by the shoelace formula on the published corners, times the height.
    EXPECT_NEAR(volume(meshes[kShort]), 27633 * 165.0, 1e-6);
    EXPECT_NEAR(volume(meshes[kTall]), 27626.5 * 330, 1e-6);
}

TEST(Cornell, each_reflectance_has_76_values_within_0_and_1) {
    const std::vector<std::string> words = pbrt_words(cornell_scene().at(0).bytes);
    int spectra = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] != "\"spectrum reflectance") continue;
        ++spectra;
        const std::vector<float> numbers = pbrt_numbers(words, i, "spectrum reflectance");
        ASSERT_EQ(numbers.size(), 2 * 76);
        for (std::size_t k = 0; k < 76; ++k) {
            EXPECT_EQ(numbers[2 * k], static_cast<float>(400 + 4 * k));
            EXPECT_GT(numbers[2 * k + 1], 0);
            EXPECT_LT(numbers[2 * k + 1], 1);
        }
    }
    EXPECT_EQ(spectra, 3);
}

}  // namespace
}  // namespace sunfleck::engine
