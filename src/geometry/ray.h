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

/// The intersection of a ray with a surface; or a point in a medium, of no shape.
struct Hit {
    Vec3 position;  // computed from barycentric coordinates, not from t
    Vec3 normal;    // geometric, unit; points to the outside in pbrt's sense, not to the ray's side
    Vec3 shading_normal;  // unit, in the hemisphere of `normal`
    Vec3 tangent;         // dp/du, any length; for anisotropic roughness
    Vec2 uv;
    Vec2 weights{0};          // of corners 1 and 2 of a triangle (barycentric); 0 on other shapes
    float error = 0;          // bound of the distance to the exact surface, along each axis
    float distance = 0;       // along the ray
    std::uint32_t shape = 0;  // index into the list that the geometry was built from, or kNone
    std::uint32_t primitive = 0;  // triangle or patch of a mesh, piece of a curve; 0 for quadrics
    std::uint32_t instance = kNone;  // index into Geometry's instances, or kNone
};

/// Returns a point in a medium, where paths scatter as at a surface. Its normal means nothing.
inline Hit point_in_medium(const Vec3& position) {
    Hit hit;
    hit.position = position;
    hit.normal = hit.shading_normal = Vec3(0, 0, 1);
    hit.tangent = Vec3(1, 0, 0);
    hit.shape = kNone;
    return hit;
}

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
