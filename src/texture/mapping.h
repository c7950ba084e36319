// Texture mappings: from a surface point to texture coordinates.
//
// Frames: the texture's frame is that of the current matrix at its statement; `to_texture` maps
// world coordinates to it.
#pragma once

#include "geometry/affine.h"
#include "geometry/ray.h"

#include <variant>

namespace sunfleck::engine {

/// The surface point at which a texture is evaluated.
struct TexturePoint {
    Vec3 position{0};  // in rendering space, as for rays
    Vec3 normal{0};    // geometric, unit, either side
    Vec2 uv{0};
    Vec3d origin{0};  // of rendering space, in the world

    TexturePoint() = default;
    TexturePoint(const Vec3& p, const Vec3& n, const Vec2& at) : position(p), normal(n), uv(at) {}
    explicit TexturePoint(const Hit& hit, const Vec3d& origin_of_space = Vec3d(0))
        : position(hit.position), normal(hit.normal), uv(hit.uv), origin(origin_of_space) {}

    /// Returns the position in world coordinates, as in the scene file.
    Vec3d in_world() const { return Vec3d(position) + origin; }
};

/// uv * scale + shift.
struct UvMapping {
    Vec2 scale{1, 1};
    Vec2 shift{0, 0};
    Vec2 at(const TexturePoint& point) const { return point.uv * scale + shift; }
};

/// (u dot uv, v dot uv) + shift.
struct TurnedUvMapping {
    Vec2 u{1, 0};
    Vec2 v{0, 1};
    Vec2 shift{0, 0};
    Vec2 at(const TexturePoint& point) const {
        return Vec2(u.dot(point.uv), v.dot(point.uv)) + shift;
    }
};

/// The angle from the z axis over pi; azimuth over 2 pi.
struct SphericalMapping {
    Affine to_texture;
    Vec2 at(const TexturePoint& point) const;
};

/// The azimuth from -x over 2 pi; z.
struct CylindricalMapping {
    Affine to_texture;
    Vec2 at(const TexturePoint& point) const;
};

/// Dot products with two vectors, plus a shift.
struct PlanarMapping {
    Affine to_texture;
    Vec3 v1{1, 0, 0};
    Vec3 v2{0, 1, 0};
    Vec2 shift{0, 0};
    Vec2 at(const TexturePoint& point) const;
};

using Mapping =
    std::variant<UvMapping, TurnedUvMapping, SphericalMapping, CylindricalMapping, PlanarMapping>;

inline Vec2 place(const Mapping& mapping, const TexturePoint& point) {
    return std::visit([&](const auto& m) { return m.at(point); }, mapping);
}

/// The point itself, in the texture's frame.
struct PointMapping {
    Affine to_texture;
    Vec3 at(const TexturePoint& point) const { return Vec3{to_texture.point(point.in_world())}; }
};

}  // namespace sunfleck::engine
