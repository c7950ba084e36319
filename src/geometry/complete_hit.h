// Completes a hit from the primitive that Embree names: position, normals, tangent and error, in
// double.
//
// In:  the primitive and the ray. Out: values that depend on these alone, not on Embree's float
// barycentrics (whose last bits differ between processors, through the approximate reciprocal).
#pragma once

#include "geometry/built.h"
#include "geometry/line.h"
#include "geometry/ray.h"

#include <cstdint>

namespace sunfleck::engine {

/// What Embree found, by the numbers of the input.
struct Found {
    const BuiltShape* shape = nullptr;
    const BuiltInstance* instance = nullptr;  // or null
    std::uint32_t primitive = 0;
    Vec2d weights;  // Embree's, of corners 1 and 2
    double t = 0;   // of an exact shape
};

/// Sets all of the hit but the numbers of shape and instance.
/// @param line  in the world, direction unit.
void complete_hit(const Found& found, const Line& line, Hit& hit);

}  // namespace sunfleck::engine
