// What a shape must offer to be traced exactly, in double, in its own frame (all but meshes of
// triangles).
#pragma once

#include "geometry/affine.h"
#include "geometry/bounds.h"
#include "math/vector.h"

#include <array>
#include <concepts>
#include <cstdint>

namespace sunfleck::engine {

/// Points where a line meets a surface, in any order. Those on a part that was cut away, or that
/// do not exist, are not `on`.
template <std::size_t N>
struct CrossingsOf {
    std::array<double, N> t{};
    std::array<bool, N> on{};
};

/// Of a quadric or a patch; first the one with the lesser t.
using Crossings = CrossingsOf<2>;

/// A surface around one of its points, in the object frame.
struct LocalSurface {
    Vec3d position = Vec3d(0);
    Vec3d normal = Vec3d(0);   // unit, outside
    Vec3d tangent = Vec3d(0);  // dp/du, never zero
    Vec2 uv = Vec2(0);         // as pbrt-v4
    /// dp/dv; zero where it is not known, and bumps then take the normal times dp/du.
    Vec3d cotangent = Vec3d(0);
    Vec3d given_normal = Vec3d(0);  // of the file, any length; zero: none. It decides the outside
    /// How far rays must start from the position so as not to meet the surface there again,
    /// besides what rounding asks for: zero for all surfaces that do not turn with the ray.
    double clearance = 0;
};

/// crossings: with the line origin + t * direction, any length of direction but zero.
/// at:        the surface at the point that `near` is a rounding error away from, met by a line
///            along `direction`.
/// bounds:    of the image under a map (of the whole, where a part is cut away).
template <class S>
concept ExactShape = std::copyable<S> && requires(const S& s, const Vec3d& p, const Affine& map) {
    s.crossings(p, p).on;
    { s.at(p, p) } -> std::same_as<LocalSurface>;
    { s.bounds(map) } -> std::same_as<Bounds>;
};

/// Many surfaces of one kind, numbered: what Hit::primitive tells apart.
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

/// How many surfaces: one, unless there are many; none of a mesh of triangles.
template <class S>
std::uint32_t exact_count(const S& shape) {
    if constexpr (ExactShape<S>) return 1;
    if constexpr (ExactShapes<S>) return shape.count();
    return 0;
}

/// What `use` makes of surface i; `nothing` for a mesh of triangles.
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
