// Texture mappings: from a surface point to texture coordinates.
//
// Frames: the texture's frame is that of the current matrix at its statement; `to_texture` maps
// world coordinates to it.
#pragma once

#include "geometry/affine.h"
#include "geometry/ray.h"

#include <array>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace sunfleck::engine {

/// The surface point at which a texture is evaluated.
struct TexturePoint {
    Vec3 position{0};  // in rendering space, as for rays
    Vec3 normal{0};    // geometric, unit, either side
    Vec2 uv{0};
    Vec3d origin{0};              // of rendering space, in the world
    std::uint32_t primitive = 0;  // as in Hit, with its weights
    Vec2 weights{0};

    TexturePoint() = default;
    TexturePoint(const Vec3& p, const Vec3& n, const Vec2& at) : position(p), normal(n), uv(at) {}
    explicit TexturePoint(const Hit& hit, const Vec3d& origin_of_space = Vec3d(0))
        : position(hit.position),
          normal(hit.normal),
          uv(hit.uv),
          origin(origin_of_space),
          primitive(hit.primitive),
          weights(hit.weights) {}

    /// Returns the position in world coordinates, as in the scene file.
    Vec3d in_world() const { return Vec3d(position) + origin; }
};

/// Values at the vertices of one mesh, interpolated over its triangles: colours, or other
/// coordinates than the mesh's own. Only shapes with these triangles may be textured by it.
/// @tparam V  a vector.
template <class V>
struct VertexValues {
    using Triangles = std::vector<std::array<std::uint32_t, 3>>;

    std::shared_ptr<const Triangles> triangles;
    std::shared_ptr<const std::vector<V>> values;  // one per vertex

    V at(const TexturePoint& point) const {
        const auto& corners = (*triangles)[point.primitive];
        const Vec2& w = point.weights;
        return (*values)[corners[0]] * (1 - w.x - w.y) + (*values)[corners[1]] * w.x +
               (*values)[corners[2]] * w.y;
    }
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

/// Coordinates of vertices, turned.
struct VertexMapping {
    VertexValues<Vec2> coordinates;
    TurnedUvMapping turned;
    Vec2 at(const TexturePoint& point) const {
        TexturePoint other = point;
        other.uv = coordinates.at(point);
        return turned.at(other);
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

using Mapping = std::variant<UvMapping, TurnedUvMapping, VertexMapping, SphericalMapping,
                             CylindricalMapping, PlanarMapping>;

inline Vec2 place(const Mapping& mapping, const TexturePoint& point) {
    return std::visit([&](const auto& m) { return m.at(point); }, mapping);
}

/// The point itself, in the texture's frame.
struct PointMapping {
    Affine to_texture;
    Vec3 at(const TexturePoint& point) const { return Vec3{to_texture.point(point.in_world())}; }
};

}  // namespace sunfleck::engine
