// The alpha test: a hash of the ray and of the primitive decides whether a ray meets a surface that
// is there in part, and the decision is the same for all who ask.
//
// Source: pbrt-v4's stochastic alpha test; the primitive is hashed with the ray, so that one ray
// passes through several sheets independently.
#pragma once

#include "geometry/ray.h"

#include <cstdint>
#include <functional>

namespace sunfleck::engine {

/// The part of a surface that is there at a hit: 1 all, 0 nothing; in between, a ray meets it with
/// that probability. Called by any number of threads; shape and instance of the hit are not set.
using Cover = std::function<float(const Hit&)>;

/// Where a surface is there in part: do rays meet it by chance, or always?
enum class AlphaTest : std::uint8_t {
    by_chance,  // as often as its cover says, by a hash of the ray
    off         // always: who asks decides with Geometry::is_there() whether it stops the ray
};

/// One crossing of a ray with a primitive; the numbers need to tell crossings apart, no more.
struct CrossingName {
    std::uint32_t shape = 0;
    std::uint32_t primitive = 0;
    std::uint32_t instance = 0;
    std::uint32_t crossing = 0;  // of those of the ray with the primitive
};

/// The alpha test: true with probability `cover`, by a hash of the ray and of the crossing.
/// @param origin, direction  of the ray, in the world.
bool passes_alpha_test(float cover, const Vec3d& origin, const Vec3d& direction,
                       const CrossingName& name);

}  // namespace sunfleck::engine
