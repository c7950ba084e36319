// From a point of a surface to the place in a texture.
//
// Frames: the texture's own frame is that of the matrix that stood at its statement; `to_texture`
// leads there from the world.
#pragma once

#include "geometry/affine.h"
#include "geometry/ray.h"

#include <variant>

namespace sunfleck::engine {

/// What a texture may know of the point where it is asked.
struct TexturePoint {
    Vec3 position{0};  // as rays have it: in rendering space
    Vec3 normal{0};    // geometric, unit, either side
    Vec2 uv{0};
    Vec3d origin{0};  // of rendering space, in the world

    TexturePoint() = default;
    TexturePoint(const Vec3& p, const Vec3& n, const Vec2& at) : position(p), normal(n), uv(at) {}
    explicit TexturePoint(const Hit& hit, const Vec3d& origin_of_space = Vec3d(0))
        : position(hit.position), normal(hit.normal), uv(hit.uv), origin(origin_of_space) {}

    /// In the world's coordinates, as the scene's file has them.
    Vec3d in_world() const { return Vec3d(position) + origin; }
};

/// uv * scale + shift.
struct UvMapping {
    Vec2 scale{1, 1};
    Vec2 shift{0, 0};
    Vec2 at(const TexturePoint& point) const { return point.uv * scale + shift; }
};

/// Angle from the z axis over pi; azimuth over a turn.
struct SphericalMapping {
    Affine to_texture;
    Vec2 at(const TexturePoint& point) const;
};

/// Azimuth, from -x, over a turn; z.
struct CylindricalMapping {
    Affine to_texture;
    Vec2 at(const TexturePoint& point) const;
};

/// Products with two vectors, and a shift.
struct PlanarMapping {
    Affine to_texture;
    Vec3 v1{1, 0, 0};
    Vec3 v2{0, 1, 0};
    Vec2 shift{0, 0};
    Vec2 at(const TexturePoint& point) const;
};

using Mapping = std::variant<UvMapping, SphericalMapping, CylindricalMapping, PlanarMapping>;

inline Vec2 place(const Mapping& mapping, const TexturePoint& point) {
    return std::visit([&](const auto& m) { return m.at(point); }, mapping);
}

/// The point itself, in the texture's frame.
struct PointMapping {
    Affine to_texture;
    Vec3 at(const TexturePoint& point) const { return Vec3{to_texture.point(point.in_world())}; }
};

}  // namespace sunfleck::engine
