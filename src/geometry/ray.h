// Rays and hits.
#pragma once

#include "math/vector.h"

#include <cstdint>
#include <limits>

namespace sunfleck::engine {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// Points origin + t * direction with 0 < t < length; world frame, scene units.
struct Ray {
    Vec3 origin;
    Vec3 direction;  // unit vector
    float length = kInfinity;
};

/// The intersection of a ray with a surface.
struct Hit {
    Vec3 position;  // computed from barycentric coordinates, not from t
    Vec3 normal;    // geometric, unit; points to the outside in pbrt's sense, not to the ray's side
    Vec3 shading_normal;  // unit, in the hemisphere of `normal`
    Vec3 tangent;         // dp/du, any length; for anisotropic roughness
    Vec2 uv;
    Vec2 weights{0};          // of corners 1 and 2 of a triangle (barycentric); 0 on other shapes
    float error = 0;          // bound of the distance to the exact surface, along each axis
    float distance = 0;       // along the ray
    std::uint32_t shape = 0;  // index into the list that the geometry was built from
    std::uint32_t primitive = 0;  // triangle or patch of a mesh, piece of a curve; 0 for quadrics
    std::uint32_t instance = kNone;  // index into Geometry's instances, or kNone
};

/// Returns the origin for a ray that leaves the surface into `direction` and must not hit it again:
/// the position moved along the geometric normal by the error bound, to the side of `direction`.
/// Source: Waechter and Binder, A Fast and Robust Method for Avoiding Self-Intersection (Ray
/// Tracing Gems, 2019), for the idea; the bound comes with our hit.
inline Vec3 offset_origin(const Vec3& position, const Vec3& normal, float error,
                          const Vec3& direction) {
    const float side = normal.dot(direction) >= 0 ? error : -error;
    return position + normal * side;
}

}  // namespace sunfleck::engine
