// All surfaces of a scene, ready to be traced: the only door to Embree.
//
// In:  shapes with their object-to-world matrices; objects and instances of them.
// Out: nearest hits and occlusion. Immutable once built; any number of threads may trace.
// Same bytes on every x86-64 with AVX2: Embree opened with isa=avx2, medium quality, robust,
// single-ray kernels only (docs/develop/decisions.md). Embree says only which primitive is hit;
// where, is worked out again in double.
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

/// What a ray meets, by name alone: where on it, is to be worked out.
struct Meeting {
    Vec3d origin{0};  // of the ray
    Vec3d direction{0};
    double walked = 0;            // from there to where the trace began
    std::uint32_t shape = kNone;  // none: the ray meets nothing
    std::uint32_t primitive = 0;
    std::uint32_t instance = kNone;
    bool precise = false;  // asked for by meet_precise()
    AlphaTest alpha_test = AlphaTest::by_chance;
    Vec2 weights{0};  // Embree's, of corners 1 and 2
    double t = 0;     // of a shape that is intersected exactly, from where the trace began
};

/// Left out, for nothing can be hit there: triangles without area, with a corner that is not
/// in the list; spheres, disks and instances under a matrix without an inverse; what is not finite
/// or farther out than 1e18.
/// Triangles keep their numbers.
class Geometry {
public:
    /// @param isa  "avx2" (the promise of equal bytes), or "native" (whatever Embree picks).
    /// @throws std::runtime_error when Embree cannot build (memory), or on another `isa`.
    explicit Geometry(GeometryInput input, const std::string& isa = "avx2");
    ~Geometry();
    Geometry(Geometry&&) noexcept;
    Geometry& operator=(Geometry&&) noexcept;
    Geometry(const Geometry&) = delete;
    Geometry& operator=(const Geometry&) = delete;

    /// The nearest surface strictly between the ray's ends (t of a triangle is good to some 2^-22
    /// of itself). A ray that is not finite (or starts beyond 1e18)
    /// hits nothing.
    std::optional<Hit> intersect(const Ray& ray) const;
    /// The nearest surface for a ray that starts far away (a camera or a sun 10 km off), as if all
    /// were done in double: see the definition for the how. Costs up to four traces when the hit is
    /// far compared with the precision that floats have at the hit, one otherwise. A ray that
    /// starts a thousand sizes of the scene away costs no more than one from near.
    /// @param direction  unit.
    std::optional<Hit> intersect_precise(const Vec3d& origin, const Vec3d& direction) const;
    /// intersect() and intersect_precise() in two halves, with time between them: the first asks
    /// Embree and calls the primitive into the cache, the second works out the hit. Whoever traces
    /// several paths in turn waits for neither.
    Meeting meet(const Ray& ray, AlphaTest alpha_test = AlphaTest::by_chance) const;
    Meeting meet_precise(const Vec3d& origin, const Vec3d& direction,
                         AlphaTest alpha_test = AlphaTest::by_chance) const;
    /// @return whether the ray meets anything; if not, `hit` is left in any state.
    bool hit_of(const Meeting& meeting, Hit& hit) const;

    /// The alpha test of a hit that was found without: is the surface there for this ray? A hash
    /// of the ray and of the primitive decides.
    bool is_there(const Hit& hit, const Vec3d& origin, const Vec3& direction) const;

    /// Around a hit of this geometry.
    SurfaceDerivatives derivatives(const Hit& hit) const;

    /// Is there any surface strictly between the ray's ends?
    bool occluded(const Ray& ray) const;

    /// Holds all surfaces; tight for shapes in the world, a box around the object's turned box for
    /// an instance. Empty for an empty scene.
    const Bounds& bounds() const;
    const GeometryInput& input() const;
    /// Of the input; an instance counts all its triangles.
    std::size_t triangle_count() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sunfleck::engine
