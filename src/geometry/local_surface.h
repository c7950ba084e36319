// Concepts of exact shapes: what a shape other than a triangle mesh provides to be intersected in
// double, in its own frame.
#pragma once

#include "geometry/affine.h"
#include "geometry/bounds.h"
#include "math/vector.h"

#include <array>
#include <concepts>
#include <cstdint>

namespace sunfleck::engine {

/// Intersections of a line with a surface, in any order. Those on a part that is cut away, and
/// unused ones, are not `on`.
template <std::size_t N>
struct CrossingsOf {
    std::array<double, N> t{};
    std::array<bool, N> on{};
};

/// Intersections of a quadric or patch; the one with smaller t comes first.
using Crossings = CrossingsOf<2>;

/// The surface at one of its points, in the object frame.
struct LocalSurface {
    Vec3d position = Vec3d(0);
    Vec3d normal = Vec3d(0);   // unit, outside
    Vec3d tangent = Vec3d(0);  // dp/du, never zero
    Vec2 uv = Vec2(0);         // as in pbrt-v4
    /// dp/dv; zero if unknown, and bump mapping then uses the normal times dp/du.
    Vec3d cotangent = Vec3d(0);
    Vec3d given_normal = Vec3d(0);  // from the file, or zero; selects the outside
    /// Extra distance from the position at which rays must start so that they do not hit the
    /// surface again, besides rounding; zero unless the surface turns to face the ray.
    double clearance = 0;
};

/// crossings: intersections with the line origin + t * direction, for any non-zero direction.
/// at:        the surface near `near`, which is a rounding error away, hit along `direction`.
/// bounds:    of the image under a map (of the full surface, where a part is cut away).
template <class S>
concept ExactShape = std::copyable<S> && requires(const S& s, const Vec3d& p, const Affine& map) {
    s.crossings(p, p).on;
    { s.at(p, p) } -> std::same_as<LocalSurface>;
    { s.bounds(map) } -> std::same_as<Bounds>;
};

/// A shape of many numbered surfaces; Hit::primitive is the number.
template <class S>
concept ExactShapes = std::copyable<S> && requires(const S& s, std::uint32_t i) {
    { s.count() } -> std::same_as<std::uint32_t>;
    requires ExactShape<decltype(s.element(i))>;
};

/// area: of the image under a map; relative error below 1e-6.
template <class S>
concept HasArea = requires(const S& s, const Affine& map) {
    { s.area(map) } -> std::same_as<double>;
};

/// Returns the number of exact surfaces: one by default, none for a triangle mesh.
template <class S>
std::uint32_t exact_count(const S& shape) {
    if constexpr (ExactShape<S>) return 1;
    if constexpr (ExactShapes<S>) return shape.count();
    return 0;
}

/// Returns use(surface i), or `nothing` for a triangle mesh.
template <class S, class Use, class Result>
Result with_exact(const S& shape, [[maybe_unused]] std::uint32_t i, const Use& use,
                  const Result& nothing) {
    if constexpr (ExactShape<S>)
        return use(shape);
    else if constexpr (ExactShapes<S>)
        return use(shape.element(i));
    else
        return nothing;
}

}  // namespace sunfleck::engine
