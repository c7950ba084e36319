// Surfaces: the geometry of a scene, with material and media per shape.
//
// Thread-safe. Positions are relative to the origin of rendering space.
#pragma once

#include "geometry/geometry.h"
#include "material/material.h"
#include "scene/media.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace sunfleck::engine {

/// What the scene knows of a shape besides its geometry.
struct ShapeRecord {
    std::uint32_t material = 0;
    std::uint32_t first_light = kNone;  // light of primitive 0, if it emits; others follow
    MediumSides media{};
    bool has_cover = false;  // the alpha test applies
};

class Surfaces {
public:
    /// @param records  one per shape of the geometry. @param isa  see Geometry.
    Surfaces(GeometryInput geometry, const std::string& isa, std::vector<ShapeRecord> records,
             std::vector<Material> materials);

    const Geometry& geometry() const { return geometry_; }
    const std::vector<Material>& materials() const { return materials_; }

    std::uint32_t material_of(const Hit& hit) const { return records_[hit.shape].material; }
    /// Returns the area light at a hit, or kNone.
    std::uint32_t light_of(const Hit& hit) const;
    /// Returns whether the surface is a null interface, which paths pass without a scattering
    /// event; shadow rays, camera and photon paths alike. (Interfaces that do not emit are not in
    /// the geometry.)
    bool is_null_interface(const Hit& hit) const {
        return std::holds_alternative<InterfaceMaterial>(materials_[material_of(hit)]);
    }
    /// Returns whether light can continue behind the surface.
    bool lets_light_through(const Hit& hit) const;
    /// Returns whether the surface has alpha; Geometry::is_there() then decides whether it stops a
    /// ray.
    bool has_cover(const Hit& hit) const { return records_[hit.shape].has_cover; }
    /// Returns whether a segment is unoccluded, null interfaces aside.
    bool is_free(const Ray& ray) const;

    const MediumSides& media_of(std::uint32_t shape) const { return records_[shape].media; }
    bool separates_media(const Hit& hit) const { return media_of(hit.shape).differ(); }
    /// Returns the medium of a path that leaves a hit into `direction`, or a point in a medium.
    /// @param before  medium of the path before.
    MediumNumber medium_beyond(const Hit& hit, const Vec3& direction, MediumNumber before) const {
        if (hit.shape == kNone) return before;
        const MediumSides& sides = media_of(hit.shape);
        return sides.differ() ? sides.towards(hit.normal, direction) : before;
    }
    /// Exchanges the media on the two sides of a shape.
    void exchange_media(std::uint32_t shape);
    /// As compensate_energy() of scene/adjust.h.
    void compensate_energy();

private:
    std::vector<Material> materials_;
    std::vector<ShapeRecord> records_;
    bool has_straight_hits_ = false;
    Geometry geometry_;
};

/// Returns the ray that continues along `direction` from a hit, past its surface.
inline Ray ray_from(const Hit& hit, const Vec3& direction) {
    return {offset_origin(hit.position, hit.normal, hit.error, direction), direction};
}

/// Returns the segment from a hit towards a point `distance` away, with its end shortened.
inline Ray shadow_ray(const Hit& hit, const Vec3& direction, float distance) {
    Ray ray = ray_from(hit, direction);
    ray.length = distance * (1 - 1e-4F);
    return ray;
}

}  // namespace sunfleck::engine
