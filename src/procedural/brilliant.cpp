// The brilliant's corners, ring by ring, and its facets between them.

#include "procedural/brilliant.h"

#include "math/trigonometry.h"

namespace sunfleck::engine {
namespace {

constexpr std::uint32_t kFold = 8;

/// Appends `count` corners at one radius and height, the first `turn` full turns from the x axis.
std::uint32_t add_ring(Mesh& mesh, std::uint32_t count, double turn, double radius, double height) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        const SinCos at = sin_cos_2pi(turn + static_cast<double>(i) / count);
        mesh.points.push_back({static_cast<float>(radius * at.cos),
                               static_cast<float>(radius * at.sin), static_cast<float>(height)});
    }
    return first;
}

}  // namespace

Mesh brilliant(const BrilliantCut& cut) {
    constexpr double kHalf = 0.5 / kFold;
    const double narrow = sin_cos_2pi(kHalf).cos;  // of the way from a facet's ridge to its middle
    const double star = cut.table * narrow + cut.star * (1 - cut.table * narrow);
    const double lower = 1 - cut.lower;
    const double top = cut.girdle;
    Mesh mesh;
    const auto table =
        add_ring(mesh, kFold, 0, cut.table, top + (1 - cut.table) * cut.crown_tangent);
    const auto stars =
        add_ring(mesh, kFold, kHalf, star, top + (1 - star * narrow) * cut.crown_tangent);
    const auto upper_edge = add_ring(mesh, 2 * kFold, 0, 1, top);
    const auto lower_edge = add_ring(mesh, 2 * kFold, 0, 1, 0);
    const auto halves =
        add_ring(mesh, kFold, kHalf, lower, (lower * narrow - 1) * cut.pavilion_tangent);
    const auto culet = add_ring(mesh, 1, 0, 0, -cut.pavilion_tangent);
    for (std::uint32_t i = 0; i < kFold; ++i) {
        const std::uint32_t next = (i + 1) % kFold;
        const std::uint32_t last = (i + kFold - 1) % kFold;
        const std::uint32_t ridge = 2 * i;  // corners of the girdle: on a ridge, and between two
        const std::uint32_t between = ridge + 1;
        const std::uint32_t next_ridge = 2 * next;
        if (i >= 2) mesh.triangles.push_back({table, table + i - 1, table + i});
        mesh.triangles.push_back({table + i, stars + i, table + next});
        mesh.add_quad(table + i, stars + last, upper_edge + ridge, stars + i);
        mesh.triangles.push_back({stars + i, upper_edge + ridge, upper_edge + between});
        mesh.triangles.push_back({stars + i, upper_edge + between, upper_edge + next_ridge});
        mesh.add_quad(lower_edge + ridge, lower_edge + between, upper_edge + between,
                      upper_edge + ridge);
        mesh.add_quad(lower_edge + between, lower_edge + next_ridge, upper_edge + next_ridge,
                      upper_edge + between);
        mesh.triangles.push_back({halves + i, lower_edge + between, lower_edge + ridge});
        mesh.triangles.push_back({halves + i, lower_edge + next_ridge, lower_edge + between});
        mesh.add_quad(culet, halves + i, lower_edge + ridge, halves + last);
    }
    return mesh;
}

}  // namespace sunfleck::engine
