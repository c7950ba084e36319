// Filters for Embree, and the hash that decides.
#include "geometry/cover.h"

#include <embree3/rtcore_ray.h>

#include <bit>

namespace sunfleck {
namespace {

/// A bijection of 64 bits after which all of them depend on all.
/// Source: Stafford, Better Bit Mixing (2011), variant 13, as used by SplitMix64.
std::uint64_t mixed(std::uint64_t bits) {
    bits = (bits ^ bits >> 30U) * 0xBF58476D1CE4E5B9;
    bits = (bits ^ bits >> 27U) * 0x94D049BB133111EB;
    return bits ^ bits >> 31U;
}

std::uint64_t joined(std::uint64_t hash, std::uint64_t bits) {
    return mixed(hash + 0x9E3779B97F4A7C15 + bits);
}

std::uint64_t hash_of(const Line& line) {
    std::uint64_t hash = 0;
    for (const Vec3d& v : {line.origin, line.direction})
        for (int i = 0; i < 3; ++i) hash = joined(hash, std::bit_cast<std::uint64_t>(v[i]));
    return hash;
}

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
    Hit hit;
    complete_hit(found, query.line, hit);
    const float cover = found.shape->cover()(hit);
    if (cover >= 1) return true;
    if (!(cover > 0)) return false;
    const Line& ray = query.whole == nullptr ? query.line : *query.whole;
    std::uint64_t hash = joined(hash_of(ray), std::uint64_t{geometry} << 32U | found.primitive);
    const auto instance = static_cast<std::uint64_t>(
        found.instance == nullptr ? 0 : found.instance - query.instances->data() + 1);
    hash = joined(hash, instance << 32U | crossing);
    return static_cast<float>(hash >> 40U) * 0x1p-24F < cover;
}

void attach_cover(const BuiltShape& mesh) {
    RTCGeometry g = mesh.geometry();
    rtcSetGeometryUserData(g, const_cast<BuiltShape*>(&mesh));  // NOLINT: only ever read
    rtcSetGeometryIntersectFilterFunction(g, filter);
    rtcSetGeometryOccludedFilterFunction(g, filter);
    rtcCommitGeometry(g);
}

}  // namespace sunfleck
