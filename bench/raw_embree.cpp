// Recording rays on their way to Embree, and tracing them with Embree alone.
#include "raw_embree.h"

#include "core/parallel.h"

#include <dlfcn.h>
#include <embree3/rtcore_ray.h>

#include <atomic>
#include <limits>

namespace sunfleck::engine::bench {
namespace {

constexpr std::size_t kBlock = 1024;

using Intersect = void (*)(RTCScene, RTCIntersectContext*, RTCRayHit*);
using Occluded = void (*)(RTCScene, RTCIntersectContext*, RTCRay*);

/// Embree's own function of that name.
template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));  // NOLINT(*-reinterpret-cast)
}

void intersect(RTCScene scene, RTCIntersectContext* context, RTCRayHit* ray) {
    static const auto embree = next<Intersect>("rtcIntersect1");
    embree(scene, context, ray);
}

void occluded(RTCScene scene, RTCIntersectContext* context, RTCRay* ray) {
    static const auto embree = next<Occluded>("rtcOccluded1");
    embree(scene, context, ray);
}

RTCRay embree_ray(const Ray& ray) {
    RTCRay result{};
    result.org_x = ray.origin.x;
    result.org_y = ray.origin.y;
    result.org_z = ray.origin.z;
    result.tnear = std::numeric_limits<float>::min();
    result.dir_x = ray.direction.x;
    result.dir_y = ray.direction.y;
    result.dir_z = ray.direction.z;
    result.tfar = ray.length;
    result.mask = 0xFFFFFFFF;
    return result;
}

}  // namespace

/// Where rays are kept while record() runs.
struct Recorder {
    static void keep(RTCScene scene, const RTCRay& ray, bool shadow) {
        if (into == nullptr) return;
        into->world_ = scene;
        into->rays_.push_back(
            {{{ray.org_x, ray.org_y, ray.org_z}, {ray.dir_x, ray.dir_y, ray.dir_z}, ray.tfar},
             shadow});
    }
    static inline RawEmbree* into = nullptr;
};

RawEmbree RawEmbree::record(const std::function<void()>& work) {
    const ThreadLimit limit(1);
    RawEmbree result;
    Recorder::into = &result;
    work();
    Recorder::into = nullptr;
    return result;
}

std::size_t RawEmbree::trace_block(std::size_t begin, std::size_t end) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    std::size_t hits = 0;
    for (std::size_t i = begin; i < end; ++i) {
        if (rays_[i].shadow) {
            RTCRay ray = embree_ray(rays_[i].ray);
            occluded(world_, &context, &ray);
            hits += ray.tfar < 0 ? 1 : 0;
        } else {
            RTCRayHit met{embree_ray(rays_[i].ray), {}};
            met.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            met.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            intersect(world_, &context, &met);
            hits += met.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
        }
    }
    return hits;
}

std::size_t RawEmbree::trace() const {
    std::atomic<std::size_t> hits{0};
    parallel_blocks(rays_.size(), kBlock,
                    [&](std::size_t begin, std::size_t end) { hits += trace_block(begin, end); });
    return hits;
}

}  // namespace sunfleck::engine::bench

void rtcIntersect1(RTCScene scene, RTCIntersectContext* context, RTCRayHit* ray) {
    sunfleck::engine::bench::Recorder::keep(scene, ray->ray, false);
    sunfleck::engine::bench::intersect(scene, context, ray);
}

void rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* ray) {
    sunfleck::engine::bench::Recorder::keep(scene, *ray, true);
    sunfleck::engine::bench::occluded(scene, context, ray);
}
