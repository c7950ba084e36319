// Filled glasses: closed bodies of glass and drink, smooth profiles, walls that never touch.

#include "procedural/filled_glass.h"

#include "core/random.h"
#include "media_checks.h"
#include "procedural/milk.h"
#include "procedural/snifter.h"
#include "procedural/wine_glass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace sunfleck::engine {
namespace {

/// A glass, and what a glass of its kind weighs and holds.
struct Example {
    const char* name;
    GlassCurves (*curves)();
    std::size_t segments;
    double least_glass;  // ml: 100 g are 40
    double most_glass;
    double least_drink;  // ml
    double most_drink;
    double height;  // cm
};

constexpr std::array<Example, 3> kExamples = {{
    {"snifter", snifter_curves, kSnifterSegments, 40, 100, 60, 130, 13.46},
    {"wine_glass", wine_glass_curves, kWineGlassSegments, 50, 120, 130, 260, 22.66},
    {"tumbler", milk_glass_curves, kMilkGlassSegments, 50, 130, 130, 320, 10.9},
}};

void PrintTo(const Example& example, std::ostream* out) {
    *out << example.name;
}

class EveryFilledGlass : public testing::TestWithParam<Example> {
protected:
    FilledGlassProfiles profiles_ = filled_glass_profiles(GetParam().curves());
    FilledGlass glass_ = filled_glass(GetParam().curves(), GetParam().segments);
};

TEST_P(EveryFilledGlass, its_body_is_closed_and_weighs_what_such_a_glass_weighs) {
    EdgeCounts counts;
    count_edges(counts, glass_.glass_air);
    count_edges(counts, glass_.liquid_glass, true);
    EXPECT_TRUE(open_edges(counts).empty());
    const double body = volume(glass_.glass_air) - volume(glass_.liquid_glass);
    EXPECT_GT(body, GetParam().least_glass);
    EXPECT_LT(body, GetParam().most_glass);
}

TEST_P(EveryFilledGlass, the_drink_is_closed_and_of_a_generous_measure) {
    EdgeCounts counts;
    count_edges(counts, glass_.liquid_glass);
    count_edges(counts, glass_.liquid_air);
    EXPECT_TRUE(open_edges(counts).empty());
    const double measure = volume(glass_.liquid_glass) + volume(glass_.liquid_air);
    EXPECT_GT(measure, GetParam().least_drink);
    EXPECT_LT(measure, GetParam().most_drink);
}

TEST_P(EveryFilledGlass, stands_a_tenth_of_a_millimetre_above_the_table) {
    const auto lower = [](const auto& a, const auto& b) { return a[2] < b[2]; };
    const auto& points = glass_.glass_air.points;
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), lower);
    EXPECT_FLOAT_EQ((*low)[2], 0.01F);
    EXPECT_NEAR((*high)[2], GetParam().height, 0.01);
}

constexpr int kInDrink = 2;

TEST_P(EveryFilledGlass, media_agree_along_any_line) {
    const std::vector<Interface> surfaces = {{glass_.glass_air, kGlass, kAir},
                                             {glass_.liquid_glass, kInDrink, kGlass},
                                             {glass_.liquid_air, kInDrink, kAir}};
    RandomStream random(2, Purpose::test, 0, 0);
    int through_drink = 0;
    for (int i = 0; i < 40; ++i) {
        const double height = GetParam().height;
        const Vec3d from(9 * random.next() - 4.5, -20, height * random.next());
        const Vec3d to(9 * random.next() - 4.5, 20, height * random.next());
        const auto crossings = crossings_of(surfaces, from, to - from);
        expect_consistent(crossings, kAir);
        const bool wet = std::any_of(crossings.begin(), crossings.end(),
                                     [](const Crossing& c) { return c.after == kInDrink; });
        through_drink += wet ? 1 : 0;
    }
    EXPECT_GT(through_drink, 4);
}

/// A kink of the profile would be a crease in the glass: each step turns it by a few degrees.
TEST_P(EveryFilledGlass, no_profile_has_a_kink) {
    for (const SmoothProfile& profile :
         {profiles_.glass_air, profiles_.liquid_glass, profiles_.liquid_air})
        for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
            const Imath::V2d a(profile[i].tangent.radius, profile[i].tangent.height);
            const Imath::V2d b(profile[i + 1].tangent.radius, profile[i + 1].tangent.height);
            const double cosine = a.dot(b) / a.length() / b.length();
            ASSERT_GT(cosine, 0.85)
                << profile[i].position.radius << ' ' << profile[i].position.height;
        }
}

TEST_P(EveryFilledGlass, each_normal_agrees_with_its_facets) {
    for (const Mesh* mesh : {&glass_.glass_air, &glass_.liquid_glass, &glass_.liquid_air})
        for (const auto& t : mesh->triangles) {
            const Vec3d facet = area_vector(*mesh, t).normalized();
            for (const std::uint32_t vertex : t) {
                const auto& n = mesh->normals.at(vertex);
                ASSERT_GT(facet.dot(Vec3d(n[0], n[1], n[2])), 0.7);
            }
        }
}

INSTANTIATE_TEST_SUITE_P(FilledGlass, EveryFilledGlass, testing::ValuesIn(kExamples),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace sunfleck::engine
