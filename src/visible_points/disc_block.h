// DiscBlock: eight kernels of visible points in structure-of-arrays layout, for SIMD gather tests.
#pragma once

#include "visible_points/visible_point.h"

#include <array>
#include <cstdint>

namespace sunfleck::engine {

struct alignas(32) DiscBlock {
    static constexpr std::size_t kWidth = 8;
    using Floats = std::array<float, kWidth>;
    using Integers = std::array<std::int32_t, kWidth>;

    std::array<Floats, 3> position{};
    Floats radius{};
    Floats indirect_radius{};
    std::array<Floats, 3> normal{};
    /// Bounces in the lower half; above them the kinds (none: unset places accept nothing), and
    /// whether the disc gathers on both sides.
    Integers rules{};

    static constexpr std::int32_t kBounces = 0xFFFF;
    static constexpr unsigned kKindsFrom = 16;
    static constexpr std::int32_t kBothSides = 1 << 24;

    void set(std::size_t i, const Disc& disc) {
        for (int c = 0; c < 3; ++c) {
            position.at(static_cast<std::size_t>(c)).at(i) = disc.position[c];
            normal.at(static_cast<std::size_t>(c)).at(i) = disc.normal[c];
        }
        radius.at(i) = disc.radius;
        indirect_radius.at(i) = disc.radius_for(PhotonKind::indirect);
        rules.at(i) = disc.bounces | disc.kinds << kKindsFrom | (disc.both_sides ? kBothSides : 0);
    }
};

}  // namespace sunfleck::engine
