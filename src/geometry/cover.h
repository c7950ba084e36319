// Surfaces that are there in part: whether a ray meets them is decided by a hash of the ray and of
// the primitive, the same for all who ask.
//
// Source: pbrt-v4's stochastic alpha test; the primitive is hashed with the ray, so that one ray
// passes through several sheets independently.
#pragma once

#include "geometry/built.h"

#include <cstdint>

namespace sunfleck {

/// One crossing of a ray with a primitive; the numbers need to tell crossings apart, no more.
struct CrossingName {
    std::uint32_t shape = 0;
    std::uint32_t primitive = 0;
    std::uint32_t instance = 0;
    std::uint32_t crossing = 0;  // of those of the ray with the primitive
};

/// The alpha test: true with probability `cover`, by a hash of the ray and of the crossing.
bool passes_alpha_test(float cover, const Line& ray, const CrossingName& name);

/// Is the surface there where a query's ray meets it? Always, without an alpha test.
/// @param crossing  tells apart the points where a ray meets one primitive several times.
bool is_there(const Found& found, const Query& query, std::uint32_t geometry,
              std::uint32_t crossing);

/// Makes Embree ask is_there() for each hit on the mesh, whose place in memory must last.
void attach_cover(const BuiltShape& mesh);

}  // namespace sunfleck
