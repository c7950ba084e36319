// Asks the cover as rays do that meet the surface.
#include "light/partial_emitter.h"

#include <algorithm>

namespace sunfleck::engine {

PartialEmitter::PartialEmitter(Cover cover, const CornerUvs& uvs, const EmittingSurface& surface)
    : cover_(std::move(cover)), uvs_(uvs) {
    constexpr int kAcross = 8;
    double there = 0;
    double area = 0;
    for (int i = 0; i < kAcross * kAcross; ++i) {
        const Vec2d u((i % kAcross + 0.5) / kAcross, (i / kAcross + 0.5) / kAcross);
        const SurfaceSample on = sample_surface(surface, u);
        there += on.spread * at(surface, on.position, on.normal);
        area += on.spread;
    }
    // Never zero: what midpoints miss may shine all the same.
    if (area > 0) mean_ = std::max(there / area, 1.0 / (kAcross * kAcross));
}

float PartialEmitter::at(const EmittingSurface& surface, const Vec3d& on,
                         const Vec3d& normal) const {
    Hit hit;
    hit.position = Vec3(on);
    hit.normal = Vec3(normal);
    hit.uv = uv_at(surface, uvs_, on, normal);
    return std::clamp(cover_(hit), 0.0F, 1.0F);
}

}  // namespace sunfleck::engine
