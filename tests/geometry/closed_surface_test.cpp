// Which surfaces are closed, and which way they face.
#include "geometry/closed_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct Surface {
    std::vector<Vec3> positions{};
    std::vector<Triangle> triangles{};

    /// Adds a cube that faces outwards.
    void add_cube(const Vec3& low, float side) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        for (unsigned i = 0; i < 8; ++i)
            positions.push_back(low + Vec3((i & 1U) != 0 ? side : 0, (i & 2U) != 0 ? side : 0,
                                           (i & 4U) != 0 ? side : 0));
        constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces = {
            {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
        for (const auto& f : kFaces) {
            triangles.push_back({first + f[0], first + f[1], first + f[2]});
            triangles.push_back({first + f[0], first + f[2], first + f[3]});
        }
    }
    void reverse(std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) std::swap(triangles[t][1], triangles[t][2]);
    }
    SurfaceSides sides() const { return sides_of(positions, triangles); }
};

std::string text_of(const std::vector<bool>& flags) {
    std::string text;
    for (const bool flag : flags) text += flag ? '1' : '0';
    return text;
}

std::string ones(std::size_t count) {
    return std::string(count, '1');
}
std::string zeros(std::size_t count) {
    return std::string(count, '0');
}

TEST(ClosedSurface, is_told_component_by_component) {
    Surface surface;
    surface.add_cube({0, 0, 0}, 1);
    surface.add_cube({5, 0, 0}, 1);
    surface.triangles.pop_back();
    surface.triangles.push_back({3, 3, 4});
    const SurfaceSides sides = surface.sides();
    EXPECT_EQ(text_of(sides.is_closed), ones(12) + zeros(12));
    EXPECT_EQ(text_of(sides.is_reversed), zeros(24));
}

/// Writers turn single triangles around, or all of them.
TEST(ClosedSurface, tells_the_triangles_that_face_inwards) {
    Surface surface;
    surface.add_cube({0, 0, 0}, 1);
    surface.reverse(2, 5);
    surface.add_cube({3, 0, 0}, 1);
    surface.reverse(12, 24);
    const SurfaceSides sides = surface.sides();
    EXPECT_EQ(text_of(sides.is_closed), ones(24));
    EXPECT_EQ(text_of(sides.is_reversed), zeros(2) + ones(3) + zeros(7) + ones(12));
}

/// The inner wall of a hollow body faces inwards as it should; a body within it faces outwards.
TEST(ClosedSurface, leaves_hollows_as_they_are) {
    Surface surface;
    surface.add_cube({0, 0, 0}, 9);
    surface.add_cube({1, 1, 1}, 7);
    surface.reverse(12, 24);
    surface.add_cube({3, 3, 3}, 1);
    surface.add_cube({20, 0, 0}, 1);
    surface.reverse(36, 48);
    const SurfaceSides sides = surface.sides();
    EXPECT_EQ(text_of(sides.is_reversed), zeros(36) + ones(12));
}

/// Welding joins the corners of parts that touch: four triangles at an edge.
TEST(ClosedSurface, may_touch_another_along_an_edge) {
    Surface surface;
    surface.add_cube({0, 0, 0}, 1);
    surface.add_cube({1, 1, 0}, 1);
    // The second cube's vertices 0 and 4 are the first one's 3 and 7.
    for (std::size_t t = 12; t < 24; ++t)
        for (std::uint32_t& v : surface.triangles[t]) v = v == 8 ? 3 : v == 12 ? 7 : v;
    EXPECT_EQ(text_of(surface.sides().is_closed), ones(24));
    EXPECT_EQ(text_of(surface.sides().is_reversed), zeros(24));
}

TEST(ClosedSurface, has_a_mean_chord_by_volume_and_area) {
    Surface surface;
    surface.add_cube({100, 100, 0}, 3);
    EXPECT_NEAR(mean_chord_of(surface.positions, surface.triangles), 2, 1e-6);
    EXPECT_EQ(mean_chord_of({}, {}), 0);
}

}  // namespace
}  // namespace sunfleck::engine
