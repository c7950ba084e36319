// The snifter: closed surfaces, one medium on each side of each, walls that never touch.

#include "procedural/cognac_glass.h"

#include "core/random.h"
#include "media_checks.h"
#include "mesh_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

TEST(CognacGlass, has_the_triangles_of_the_paper_less_the_table) {
    const CognacGlass glass = cognac_glass();
    EXPECT_EQ(glass.glass_air.triangles.size() + glass.liquid_glass.triangles.size(),
              2 * 60 * kCognacSegments);
    EXPECT_EQ(glass.liquid_air.triangles.size(), kCognacSegments - 2);
}

TEST(CognacGlass, the_body_of_glass_is_closed) {
    const CognacGlass glass = cognac_glass();
    EdgeCounts counts;
    count_edges(counts, glass.glass_air);
    count_edges(counts, glass.liquid_glass, true);
    EXPECT_TRUE(open_edges(counts).empty());
    const double body = volume(glass.glass_air) - volume(glass.liquid_glass);
    EXPECT_GT(body, 20);  // a snifter weighs some 100 to 150 g
    EXPECT_LT(body, 70);
}

TEST(CognacGlass, the_body_of_brandy_is_closed) {
    const CognacGlass glass = cognac_glass();
    EdgeCounts counts;
    count_edges(counts, glass.liquid_glass);
    count_edges(counts, glass.liquid_air);
    EXPECT_TRUE(open_edges(counts).empty());
    EXPECT_EQ(open_edges(glass.liquid_air).size(), kCognacSegments);
    EXPECT_EQ(open_edges(glass.liquid_glass).size(), kCognacSegments);
    Mesh liquid = glass.liquid_glass;
    const auto first = static_cast<std::uint32_t>(liquid.points.size());
    liquid.points.insert(liquid.points.end(), glass.liquid_air.points.begin(),
                         glass.liquid_air.points.end());
    for (const auto& t : glass.liquid_air.triangles)
        liquid.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    EXPECT_GT(volume(liquid), 40);  // a generous measure, in ml
    EXPECT_LT(volume(liquid), 120);
}

TEST(CognacGlass, stands_clear_of_the_table_and_is_as_high_as_it_says) {
    const CognacGlass glass = cognac_glass();
    const auto lower = [](const auto& a, const auto& b) { return a[2] < b[2]; };
    const auto [low, high] =
        std::minmax_element(glass.glass_air.points.begin(), glass.glass_air.points.end(), lower);
    EXPECT_FLOAT_EQ((*low)[2], 0.01F);
    EXPECT_FLOAT_EQ((*high)[2], static_cast<float>(kSnifterHeight));
}

constexpr int kBrandy = 2;

std::vector<Interface> interfaces_of(const CognacGlass& glass) {
    return {{glass.glass_air, kGlass, kAir},
            {glass.liquid_glass, kBrandy, kGlass},
            {glass.liquid_air, kBrandy, kAir}};
}

TEST(CognacGlass, media_agree_along_any_line) {
    const auto surfaces = interfaces_of(cognac_glass());
    RandomStream random(1, Purpose::test, 0, 0);
    int through_brandy = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3d from(9 * random.next() - 4.5, -20, 12 * random.next());
        const Vec3d to(9 * random.next() - 4.5, 20, i % 2 == 0 ? from.z : 12 * random.next());
        const auto crossings = crossings_of(surfaces, from, to - from);
        expect_consistent(crossings, kAir);
        const bool wet = std::any_of(crossings.begin(), crossings.end(),
                                     [](const Crossing& c) { return c.after == kBrandy; });
        through_brandy += wet ? 1 : 0;
    }
    EXPECT_GT(through_brandy, 20);
}

TEST(CognacGlass, media_agree_from_above_down_to_the_foot) {
    const auto crossings =
        crossings_of(interfaces_of(cognac_glass()), {0.31, 0.17, 20}, {0, 0, -1});
    expect_consistent(crossings, kAir);
    ASSERT_EQ(crossings.size(), 3);
    EXPECT_EQ(crossings[0].after, kBrandy);
    EXPECT_EQ(crossings[1].after, kGlass);
    EXPECT_EQ(crossings[2].after, kAir);
}

double distance_to_segment(const ProfilePoint& p, const ProfilePoint& a, const ProfilePoint& b) {
    const Imath::V2d ab(b.radius - a.radius, b.height - a.height);
    const Imath::V2d ap(p.radius - a.radius, p.height - a.height);
    const double t = std::clamp(ap.dot(ab) / ab.dot(ab), 0.0, 1.0);
    return (ap - ab * t).length();
}

TEST(CognacGlass, the_wall_of_the_bowl_is_a_millimetre_thick_or_more) {
    SnifterProfile profile = snifter_profile();
    const auto rim = std::find_if(profile.glass_air.begin(), profile.glass_air.end(),
                                  [](const ProfilePoint& p) { return p.height == kSnifterHeight; });
    ASSERT_NE(rim, profile.glass_air.end());
    Profile inside(rim + 2, profile.glass_air.end());  // from below the rounded rim
    inside.insert(inside.end(), profile.glass_liquid.begin(), profile.glass_liquid.end());
    for (const ProfilePoint& p : inside)
        for (auto a = profile.glass_air.begin(); a + 1 < rim; ++a)
            ASSERT_GT(distance_to_segment(p, *a, *(a + 1)), 0.1)
                << p.radius << ' ' << p.height << " to " << a->radius << ' ' << a->height;
}

}  // namespace
}  // namespace sunfleck::engine
