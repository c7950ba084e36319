// What a shape must offer to be traced exactly, in double, in its own frame (all but meshes).
#pragma once

#include "geometry/affine.h"
#include "geometry/bounds.h"
#include "math/vector.h"

#include <array>
#include <concepts>

namespace sunfleck {

/// The two points where a line meets a closed surface, first the one with the lesser t. Those on
/// a part that was cut away, or that do not exist, are not `on`.
struct Crossings {
    std::array<double, 2> t{};
    std::array<bool, 2> on{};
};

/// A surface around one of its points, in the object frame.
struct LocalSurface {
    Vec3d position;
    Vec3d normal;   // unit, outside
    Vec3d tangent;  // dp/du, never zero
    Vec2 uv;        // as pbrt-v4
    /// dp/dv; zero where it is not known, and bumps then take the normal times dp/du.
    Vec3d cotangent{0, 0, 0};
};

/// crossings: with the line origin + t * direction, any length of direction but zero.
/// at:        the surface at the point that `near` is a rounding error away from.
/// bounds:    of the image under a map (of the whole, where a part is cut away).
/// area:      of the image under a map; relative error below 1e-6.
template <class S>
concept ExactShape = std::copyable<S> && requires(const S& s, const Vec3d& p, const Affine& map) {
    { s.crossings(p, p) } -> std::same_as<Crossings>;
    { s.at(p) } -> std::same_as<LocalSurface>;
    { s.bounds(map) } -> std::same_as<Bounds>;
    { s.area(map) } -> std::same_as<double>;
};

}  // namespace sunfleck
