// Filters for Embree: each hit is completed, and its cover asked.
#include "geometry/cover.h"

#include <embree3/rtcore_ray.h>

namespace sunfleck::engine {
namespace {

void filter(const RTCFilterFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& query = *static_cast<const Query*>(args->context);
    const auto& hit = *static_cast<const RTCHit*>(static_cast<void*>(args->hit));
    Found found;
    found.shape = static_cast<const BuiltShape*>(args->geometryUserPtr);
    found.instance = query.instance_of(hit.instID[0]);
    found.primitive = hit.primID;
    found.weights = {hit.u, hit.v};
    if (!is_there(found, query, hit.geomID, 0)) args->valid[0] = 0;
}

}  // namespace

bool is_there(const Found& found, const Query& query, std::uint32_t geometry,
              std::uint32_t crossing) {
    if (query.alpha_test == AlphaTest::off) return true;
    Hit hit;
    complete_hit(found, query.line, hit);
    const auto instance = static_cast<std::uint32_t>(
        found.instance == nullptr ? 0 : found.instance - query.instances->data() + 1);
    return passes_alpha_test(found.shape->cover()(hit), query.whole.origin, query.whole.direction,
                             {geometry, found.primitive, instance, crossing});
}

void attach_cover(const BuiltShape& mesh) {
    RTCGeometry g = mesh.geometry();
    rtcSetGeometryUserData(g, const_cast<BuiltShape*>(&mesh));  // NOLINT: only ever read
    rtcSetGeometryIntersectFilterFunction(g, filter);
    rtcSetGeometryOccludedFilterFunction(g, filter);
    rtcCommitGeometry(g);
}

}  // namespace sunfleck::engine
