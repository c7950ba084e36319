// The tumbler: bodies of glass, tea and ice that share their surfaces, ice that floats.

#include "procedural/iced_tea.h"

#include "core/random.h"
#include "media_checks.h"
#include "procedural/iced_tea_glass.h"
#include "scene_reading.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sunfleck::engine {
namespace {

void append(Mesh& to, const Mesh& mesh) {
    const auto first = static_cast<std::uint32_t>(to.points.size());
    to.points.insert(to.points.end(), mesh.points.begin(), mesh.points.end());
    for (const auto& t : mesh.triangles)
        to.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

Mesh reversed(Mesh mesh) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

TEST(IcedTea, the_body_of_glass_is_closed) {
    const IcedTea tea = iced_tea();
    Mesh body = tea.glass_air;
    append(body, reversed(tea.tea_glass));
    EXPECT_TRUE(open_edges(body).empty());
    EXPECT_GT(volume(body), 60);  // a heavy tumbler of some 200 g
    EXPECT_LT(volume(body), 130);
}

TEST(IcedTea, the_body_of_tea_is_closed) {
    const IcedTea tea = iced_tea();
    Mesh body = tea.tea_glass;
    append(body, tea.tea_air);
    append(body, reversed(tea.ice_tea));
    EXPECT_TRUE(open_edges(body).empty());
    EXPECT_GT(volume(body), 150);  // in ml
    EXPECT_LT(volume(body), 300);
}

TEST(IcedTea, ice_is_closed_and_floats_with_nine_hundredths_above_the_tea) {
    const IcedTea tea = iced_tea();
    Mesh ice = tea.ice_tea;
    append(ice, tea.ice_air);
    EXPECT_TRUE(open_edges(ice).empty());
    const double all = volume(ice);
    EXPECT_GT(all, 3 * 9);
    // The part above, as a closed body: its facets and the level's holes, whose moment about the
    // level's plane is nothing.
    double above = 0;
    for (const auto& t : tea.ice_air.triangles) {
        const double height = (corner(tea.ice_air, t[0]).z + corner(tea.ice_air, t[1]).z +
                               corner(tea.ice_air, t[2]).z) /
                                  3 -
                              kTeaLevel;
        above += height * area_vector(tea.ice_air, t).z;
    }
    EXPECT_NEAR(above / all, 0.083, 0.02);  // ice has 0.917 of the weight of water
}

Polygon corners_of(const std::vector<HalfSpace>& body) {
    Polygon corners;
    for (std::size_t i = 0; i < body.size(); ++i)
        for (const Vec3d& p : facet(body, i)) corners.push_back(p);
    return corners;
}

/// Does a face of `body` have all corners of the other a good way beyond it?
bool parts(const std::vector<HalfSpace>& body, const Polygon& corners) {
    return std::any_of(body.begin(), body.end(), [&](const HalfSpace& h) {
        return std::all_of(corners.begin(), corners.end(), [&](const Vec3d& p) {
            return h.normal.dot(p) > h.offset + 0.02 * h.normal.length();
        });
    });
}

TEST(IcedTea, no_piece_of_ice_touches_another_or_the_glass) {
    const auto cubes = ice_cubes();
    for (std::size_t i = 0; i < cubes.size(); ++i) {
        const Polygon corners = corners_of(cubes[i]);
        for (const Vec3d& p : corners) EXPECT_LT(std::hypot(p.x, p.y), 3.5);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_TRUE(parts(cubes[j], corners) || parts(cubes[i], corners_of(cubes[j])))
                << i << " and " << j;
    }
}

constexpr int kTea = 2;
constexpr int kIce = 3;

TEST(IcedTea, media_agree_along_any_line) {
    const IcedTea tea = iced_tea();
    const std::vector<Interface> surfaces = {{tea.glass_air, kGlass, kAir},
                                             {tea.tea_glass, kTea, kGlass},
                                             {tea.tea_air, kTea, kAir},
                                             {tea.ice_tea, kIce, kTea},
                                             {tea.ice_air, kIce, kAir}};
    RandomStream random(3, Purpose::test, 0, 0);
    int through_ice = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3d from(8 * random.next() - 4, -20, 10 * random.next());
        const Vec3d to(8 * random.next() - 4, 20, 10 * random.next());
        const auto crossings = crossings_of(surfaces, from, to - from);
        expect_consistent(crossings, kAir);
        const bool cold = std::any_of(crossings.begin(), crossings.end(),
                                      [](const Crossing& c) { return c.after == kIce; });
        through_ice += cold ? 1 : 0;
    }
    EXPECT_GT(through_ice, 30);
}

/// Soda-lime glass, water and ice.
TEST(IcedTea, each_surface_has_the_ratio_of_its_two_media) {
    const std::vector<std::string> words = pbrt_words(iced_tea_scene().at(0).bytes);
    constexpr double kTumblerIndex = 1.52;
    constexpr double kTeaIndex = 1.333;
    constexpr double kIceIndex = 1.31;
    EXPECT_NEAR(eta_of(words, "geometry/tumbler-air.ply"), kTumblerIndex, 1e-7);
    EXPECT_NEAR(eta_of(words, "geometry/tea-glass.ply"), kTeaIndex / kTumblerIndex, 1e-7);
    EXPECT_NEAR(eta_of(words, "geometry/tea-air.ply"), kTeaIndex, 1e-7);
    EXPECT_NEAR(eta_of(words, "geometry/ice-tea.ply"), kIceIndex / kTeaIndex, 1e-7);
    EXPECT_NEAR(eta_of(words, "geometry/ice-air.ply"), kIceIndex, 1e-7);
}

}  // namespace
}  // namespace sunfleck::engine
