// Mappings by the point's place in the texture's frame.
#include "texture/mapping.h"

#include <algorithm>

namespace sunfleck::engine {

Vec2 SphericalMapping::at(const TexturePoint& point) const {
    const Vec3 p(to_texture.point(point.in_world()));
    const float length = p.length();
    const float height = length > 0 ? std::clamp(p.z / length, -1.0F, 1.0F) : 0;
    const float azimuth = std::atan2(p.y, p.x);
    const float turn = azimuth < 0 ? azimuth + 2 * kPi : azimuth;
    return {std::acos(height) / kPi, turn / (2 * kPi)};
}

Vec2 CylindricalMapping::at(const TexturePoint& point) const {
    const Vec3 p(to_texture.point(point.in_world()));
    return {(kPi + std::atan2(p.y, p.x)) / (2 * kPi), p.z};
}

Vec2 PlanarMapping::at(const TexturePoint& point) const {
    const Vec3 p(to_texture.point(point.in_world()));
    return Vec2(p.dot(v1), p.dot(v2)) + shift;
}

}  // namespace sunfleck::engine
