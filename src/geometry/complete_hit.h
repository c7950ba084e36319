// Completes a hit on the primitive that Embree found: position, normals, tangent and error in
// double.
//
// In:  the primitive and the ray. Out: values that depend on these alone, not on Embree's float
// barycentrics, whose last bits differ between processors (approximate reciprocal).
#pragma once

#include "geometry/built.h"
#include "geometry/line.h"
#include "geometry/ray.h"

#include <cstdint>

namespace sunfleck::engine {

/// An intersection found by Embree, in terms of the input's indices.
struct Intersection {
    const BuiltShape* shape = nullptr;
    const BuiltInstance* instance = nullptr;  // or null
    std::uint32_t primitive = 0;
    Vec2d weights;  // barycentric weights from Embree, of corners 1 and 2
    double t = 0;   // ray parameter, for an exact shape
};

/// Sets all fields of the hit except the indices of shape and instance.
/// @param line  in the world, with a unit direction.
void complete_hit(const Intersection& found, const Line& line, Hit& hit);

}  // namespace sunfleck::engine
