// The scene brandy: closed bodies of glass and brandy, smooth profiles, leaves that leave a gap.

#include "procedural/brandy.h"

#include "core/random.h"
#include "media_checks.h"
#include "procedural/leaves.h"
#include "procedural/snifter.h"
#include "scene_reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

TEST(Brandy, the_body_of_glass_is_closed_and_weighs_what_a_snifter_weighs) {
    const Snifter glass = snifter();
    EdgeCounts counts;
    count_edges(counts, glass.glass_air);
    count_edges(counts, glass.brandy_glass, true);
    EXPECT_TRUE(open_edges(counts).empty());
    const double body = volume(glass.glass_air) - volume(glass.brandy_glass);
    EXPECT_GT(body, 40);  // in ml: 100 to 250 g
    EXPECT_LT(body, 100);
}

TEST(Brandy, the_body_of_brandy_is_closed_and_of_a_generous_measure) {
    const Snifter glass = snifter();
    EdgeCounts counts;
    count_edges(counts, glass.brandy_glass);
    count_edges(counts, glass.brandy_air);
    EXPECT_TRUE(open_edges(counts).empty());
    const double measure = volume(glass.brandy_glass) + volume(glass.brandy_air);
    EXPECT_GT(measure, 60);  // in ml
    EXPECT_LT(measure, 130);
}

constexpr int kInBrandy = 2;

TEST(Brandy, media_agree_along_any_line) {
    const Snifter glass = snifter();
    const std::vector<Interface> surfaces = {{glass.glass_air, kGlass, kAir},
                                             {glass.brandy_glass, kInBrandy, kGlass},
                                             {glass.brandy_air, kInBrandy, kAir}};
    RandomStream random(2, Purpose::test, 0, 0);
    int through_brandy = 0;
    for (int i = 0; i < 40; ++i) {
        const Vec3d from(9 * random.next() - 4.5, -20, 13 * random.next());
        const Vec3d to(9 * random.next() - 4.5, 20, 13 * random.next());
        const auto crossings = crossings_of(surfaces, from, to - from);
        expect_consistent(crossings, kAir);
        const bool wet = std::any_of(crossings.begin(), crossings.end(),
                                     [](const Crossing& c) { return c.after == kInBrandy; });
        through_brandy += wet ? 1 : 0;
    }
    EXPECT_GT(through_brandy, 5);
}

/// A kink of the profile would be a crease in the glass: each step turns it by a few degrees.
TEST(Brandy, no_profile_has_a_kink) {
    const SnifterProfiles profiles = snifter_profiles();
    for (const SmoothProfile& profile :
         {profiles.glass_air, profiles.brandy_glass, profiles.brandy_air})
        for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
            const Imath::V2d a(profile[i].tangent.radius, profile[i].tangent.height);
            const Imath::V2d b(profile[i + 1].tangent.radius, profile[i + 1].tangent.height);
            const double cosine = a.dot(b) / a.length() / b.length();
            ASSERT_GT(cosine, 0.85)
                << profile[i].position.radius << ' ' << profile[i].position.height;
        }
}

TEST(Brandy, each_normal_agrees_with_its_facets) {
    const Snifter glass = snifter();
    for (const Mesh* mesh : {&glass.glass_air, &glass.brandy_glass, &glass.brandy_air})
        for (const auto& t : mesh->triangles) {
            const Vec3d facet = area_vector(*mesh, t).normalized();
            for (const std::uint32_t vertex : t) {
                const auto& n = mesh->normals.at(vertex);
                ASSERT_GT(facet.dot(Vec3d(n[0], n[1], n[2])), 0.7);
            }
        }
}

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
