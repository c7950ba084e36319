// Evaluates alpha as rays do that hit the surface.
#include "light/partial_emitter.h"

#include <algorithm>
#include <utility>

namespace sunfleck::engine {

PartialEmitter::PartialEmitter(Cover cover, CornerUvs uvs, const EmittingSurface& surface)
    : cover_(std::move(cover)), uvs_(std::move(uvs)) {
    constexpr int kAcross = 8;
    double there = 0;
    double area = 0;
    for (int i = 0; i < kAcross * kAcross; ++i) {
        const int column = i % kAcross;
        const int row = i / kAcross;
        const Vec2d u((column + 0.5) / kAcross, (row + 0.5) / kAcross);
        const SurfaceSample on = sample_surface(surface, u);
        there += on.spread * at(surface, on.position, on.normal);
        area += on.spread;
    }
    // Never zero, because parts between the midpoints may emit.
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
