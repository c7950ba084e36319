// Rays that pass interfaces, and records by shape.
#include "scene/surfaces.h"

#include "scene/transmission.h"

#include <algorithm>
#include <utility>

namespace sunfleck::engine {

Surfaces::Surfaces(GeometryInput geometry, const std::string& isa, std::vector<ShapeRecord> records,
                   std::vector<Material> materials)
    : materials_(std::move(materials)),
      records_(std::move(records)),
      has_straight_hits_(std::any_of(records_.begin(), records_.end(),
                                     [this](const ShapeRecord& record) {
                                         return std::holds_alternative<InterfaceMaterial>(
                                             materials_[record.material]);
                                     })),
      geometry_(std::move(geometry), isa) {}

std::uint32_t Surfaces::light_of(const Hit& hit) const {
    const std::uint32_t first = records_[hit.shape].first_light;
    return first == kNone ? kNone : first + hit.primitive;
}

bool Surfaces::lets_light_through(const Hit& hit) const {
    return sunfleck::engine::lets_light_through(materials_, material_of(hit));
}

bool Surfaces::is_free(const Ray& ray) const {
    if (!has_straight_hits_) return !geometry_.occluded(ray);
    Ray rest = ray;
    while (const auto hit = geometry_.intersect(rest)) {
        if (!is_null_interface(*hit)) return false;
        const float left = rest.length - hit->distance;
        rest = ray_from(*hit, ray.direction);
        rest.length = left;
        if (!(left > 0)) return true;
    }
    return true;
}

void Surfaces::exchange_media(std::uint32_t shape) {
    MediumSides& media = records_[shape].media;
    std::swap(media.inside, media.outside);
}

}  // namespace sunfleck::engine
