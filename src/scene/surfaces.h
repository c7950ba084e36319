// The surfaces of a scene: their geometry, and by shape the material and the media on its sides.
//
// Any number of threads may ask. Places are relative to the origin of rendering space.
#pragma once

#include "geometry/geometry.h"
#include "material/material.h"
#include "scene/media.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace sunfleck::engine {

/// What the scene knows of one shape beyond its geometry.
struct ShapeRecord {
    std::uint32_t material = 0;
    std::uint32_t first_light = kNone;  // light of primitive 0, if it emits; the others follow
    MediumSides media{};
    bool has_cover = false;  // it is there in part: rays pass it by chance
};

class Surfaces {
public:
    /// @param records  one a shape of the geometry. @param isa  see Geometry.
    Surfaces(GeometryInput geometry, const std::string& isa, std::vector<ShapeRecord> records,
             std::vector<Material> materials);

    const Geometry& geometry() const { return geometry_; }
    const std::vector<Material>& materials() const { return materials_; }

    std::uint32_t material_of(const Hit& hit) const { return records_[hit.shape].material; }
    /// The area light at a hit, or kNone.
    std::uint32_t light_of(const Hit& hit) const;
    /// Is the surface no obstacle: light goes straight on, and it is no bounce? Shadow rays,
    /// camera and photon paths all ask here. (Interfaces that do not emit are not in the geometry.)
    bool is_null_interface(const Hit& hit) const {
        return std::holds_alternative<InterfaceMaterial>(materials_[material_of(hit)]);
    }
    /// Does any light go on beyond the surface?
    bool lets_light_through(const Hit& hit) const;
    /// Is the surface there in part? If so, Geometry::is_there() says whether it stops a ray.
    bool has_cover(const Hit& hit) const { return records_[hit.shape].has_cover; }
    /// Is the way from the start to the end of the ray free, surfaces passed straight aside?
    bool is_free(const Ray& ray) const;

    const MediumSides& media_of(std::uint32_t shape) const { return records_[shape].media; }
    bool parts_media(const Hit& hit) const { return media_of(hit.shape).parts(); }
    /// Where a path is that leaves a hit into `direction`. @param before  where it came from.
    MediumNumber medium_beyond(const Hit& hit, const Vec3& direction, MediumNumber before) const {
        const MediumSides& sides = media_of(hit.shape);
        return sides.parts() ? sides.towards(hit.normal, direction) : before;
    }
    /// Exchanges the media on the two sides of a shape.
    void exchange_media(std::uint32_t shape);

private:
    std::vector<Material> materials_;
    std::vector<ShapeRecord> records_;
    bool has_straight_hits_ = false;
    Geometry geometry_;
};

/// The next ray along `direction` from a hit, past its surface.
inline Ray ray_from(const Hit& hit, const Vec3& direction) {
    return {offset_origin(hit.position, hit.normal, hit.error, direction), direction};
}

/// The segment from a hit towards a point `distance` away, short of whatever stands there.
inline Ray shadow_ray(const Hit& hit, const Vec3& direction, float distance) {
    Ray ray = ray_from(hit, direction);
    ray.length = distance * (1 - 1e-4F);
    return ray;
}

}  // namespace sunfleck::engine
