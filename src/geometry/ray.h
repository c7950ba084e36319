// Rays, and what they hit.
#pragma once

#include "math/vector.h"

#include <cstdint>
#include <limits>

namespace sunfleck::engine {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// Points origin + t * direction, 0 < t < length. World frame, scene units.
struct Ray {
    Vec3 origin;
    Vec3 direction;  // unit
    float length = kInfinity;
};

/// Where a ray met a surface.
struct Hit {
    Vec3 position;        // on the surface, from barycentrics, not from t
    Vec3 normal;          // geometric, unit; the side that pbrt calls outside, not the ray's side
    Vec3 shading_normal;  // unit, in the hemisphere of `normal`
    Vec3 tangent;         // dp/du, any length; for anisotropic roughness
    Vec2 uv;
    float error = 0;          // position is within this distance of the true surface (each axis)
    float distance = 0;       // along the ray
    std::uint32_t shape = 0;  // index into the list that the geometry was built from
    std::uint32_t primitive = 0;  // triangle or patch of a mesh, piece of a curve; 0 for quadrics
    std::uint32_t instance = kNone;  // index into Geometry's instances, or none
};

/// Where a ray that leaves the surface into `direction` must start so as not to meet it again:
/// the position moved along the geometric normal by the error bound, to the side of `direction`.
/// Source: Waechter and Binder, A Fast and Robust Method for Avoiding Self-Intersection (Ray
/// Tracing Gems, 2019), for the idea; our bound comes with the hit.
inline Vec3 offset_origin(const Vec3& position, const Vec3& normal, float error,
                          const Vec3& direction) {
    const float side = normal.dot(direction) >= 0 ? error : -error;
    return position + normal * side;
}

}  // namespace sunfleck::engine
