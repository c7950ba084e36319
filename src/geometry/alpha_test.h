// Alpha test: whether a ray hits a surface with alpha, decided by a hash of ray and primitive.
//
// Every caller gets the same decision for the same ray and primitive.
// Source: pbrt-v4's stochastic alpha test. Here the primitive is part of the hash, so that one ray
// passes several sheets independently.
#pragma once

#include "geometry/ray.h"

#include <cstdint>
#include <functional>

namespace sunfleck::engine {

/// Alpha of a surface at a hit, the probability in [0,1] that a ray hits it. Thread-safe; shape and
/// instance of the hit are not set yet.
using Cover = std::function<float(const Hit&)>;

/// Whether the alpha test is applied during a trace.
enum class AlphaTest : std::uint8_t {
    by_chance,  // a hit counts with probability alpha, by a hash of the ray
    off         // all hits count; the caller applies Geometry::is_there() afterwards
};

/// Identifies one crossing of a ray with a primitive, by the indices needed to distinguish them.
struct CrossingName {
    std::uint32_t shape = 0;
    std::uint32_t primitive = 0;
    std::uint32_t instance = 0;
    std::uint32_t crossing = 0;  // index among the crossings of this ray with the primitive
};

/// Returns true with probability `cover`, by a hash of the ray and the crossing.
/// @param origin, direction  of the ray, in the world.
bool passes_alpha_test(float cover, const Vec3d& origin, const Vec3d& direction,
                       const CrossingName& name);

}  // namespace sunfleck::engine
