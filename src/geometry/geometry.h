// Geometry: all surfaces of a scene, ready for ray tracing; the only module that uses Embree.
//
// In:  shapes with their object-to-world matrices; objects and their instances.
// Out: nearest hits and occlusion. A geometry is immutable, and any number of threads may trace.
// The results have the same bytes on every x86-64 with AVX2: Embree runs with isa=avx2, medium
// quality, robust mode, and single-ray kernels (docs/develop/decisions.md). Embree only decides
// which primitive is hit; the hit itself is computed in double.
#pragma once

#include "geometry/alpha_test.h"
#include "geometry/bounds.h"
#include "geometry/derivatives.h"
#include "geometry/geometry_input.h"
#include "geometry/ray.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// The primitive that a ray hits; the hit itself is computed later by complete().
struct RayHit {
    Vec3d origin{0};  // of the ray
    Vec3d direction{0};
    double walked = 0;            // distance from the origin to the start of the trace
    std::uint32_t shape = kNone;  // kNone if the ray hits nothing
    std::uint32_t primitive = 0;
    std::uint32_t instance = kNone;
    bool precise = false;  // true if found by trace_precise()
    AlphaTest alpha_test = AlphaTest::by_chance;
    Vec2 weights{0};  // barycentric weights from Embree, of corners 1 and 2
    double t = 0;     // for exact shapes: ray parameter from the start of the trace
};

/// Surfaces that cannot be hit are left out: triangles without area or with an invalid vertex
/// index; spheres, disks and instances under a singular matrix; coordinates that are not finite or
/// exceed 1e18. Other triangles keep their indices.
class Geometry {
public:
    /// @param isa  "avx2" (the same bytes on every machine), or "native" (Embree's choice).
    /// @throws std::runtime_error  if Embree cannot build (memory), or for another `isa`.
    explicit Geometry(GeometryInput input, const std::string& isa = "avx2");

    /// Returns the nearest hit strictly between the ray's ends; t of a triangle has a relative
    /// error of about 2^-22. A ray that is not finite or starts beyond 1e18 hits nothing.
    std::optional<Hit> intersect(const Ray& ray) const;
    /// Returns the nearest hit of a ray that starts far away (a camera or a sun 10 km away), as if
    /// all computations were in double; see the definition for the method. It takes up to four
    /// traces if the hit is farther than float precision at the hit allows, else one. A ray that
    /// starts a thousand scene sizes away costs no more than a near one.
    /// @param direction  unit vector.
    std::optional<Hit> intersect_precise(const Vec3d& origin, const Vec3d& direction) const;
    /// intersect() and intersect_precise() in two steps: the first traces the ray and prefetches
    /// the primitive, the second computes the hit. A caller that interleaves several paths waits
    /// for neither step.
    RayHit trace(const Ray& ray, AlphaTest alpha_test = AlphaTest::by_chance) const;
    RayHit trace_precise(const Vec3d& origin, const Vec3d& direction,
                         AlphaTest alpha_test = AlphaTest::by_chance) const;
    /// @return whether the ray hits anything; if not, the value of `hit` is unspecified.
    bool complete(const RayHit& ray_hit, Hit& hit) const;

    /// Applies the alpha test to a hit of a trace without it: a hash of ray and primitive decides
    /// whether the surface stops this ray.
    bool is_there(const Hit& hit, const Vec3d& origin, const Vec3& direction) const;

    /// Returns the surface derivatives at a hit of this geometry.
    SurfaceDerivatives derivatives(const Hit& hit) const;

    /// Returns whether a surface lies strictly between the ray's ends.
    bool occluded(const Ray& ray) const;

    /// Returns bounds of all surfaces: tight for shapes in the world, a box around the object's
    /// transformed box for an instance, empty for an empty scene.
    const Bounds& bounds() const;
    const GeometryInput& input() const;
    /// Returns the number of triangles of the input; an instance counts all its triangles.
    std::size_t triangle_count() const;

private:
    struct Impl;
    std::shared_ptr<const Impl> impl_;  // copies share it
};

}  // namespace sunfleck::engine
