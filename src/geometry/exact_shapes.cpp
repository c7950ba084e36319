// The callbacks use the world's line in double, not the float ray that Embree carries into an
// instance: t is the same in all frames, and the place on the surface is exact everywhere.
#include "geometry/exact_shapes.h"

#include "geometry/cover.h"

#include <embree3/rtcore_ray.h>

#include <cmath>
#include <limits>
#include <optional>

namespace sunfleck::engine {
namespace {

/// The float next to x, and a little more, in the direction of `sign`.
float outwards(double x, double size, double sign) {
    return static_cast<float>(x + sign * (std::abs(x) + size) * 0x1p-20);
}

void write_bounds(const RTCBoundsFunctionArguments* args) {
    const auto& group = *static_cast<const ShapeGroup*>(args->geometryUserPtr);
    const ExactPrimitive& one = group.exact[args->primID];
    const Bounds box = (*group.built)[one.shape].bounds_of(one.element);
    const double size = box.radius();
    args->bounds_o->lower_x = outwards(box.min.x, size, -1);
    args->bounds_o->lower_y = outwards(box.min.y, size, -1);
    args->bounds_o->lower_z = outwards(box.min.z, size, -1);
    args->bounds_o->upper_x = outwards(box.max.x, size, 1);
    args->bounds_o->upper_y = outwards(box.max.y, size, 1);
    args->bounds_o->upper_z = outwards(box.max.z, size, 1);
}

/// The least of the crossings strictly between the ends; kNone if there is none.
template <class Crossings>
std::uint32_t next_after(const Crossings& met, double after, double before) {
    std::uint32_t which = kNone;
    for (std::uint32_t i = 0; i < met.t.size(); ++i) {
        if (!met.on[i] || !(met.t[i] > after && met.t[i] < before)) continue;
        before = met.t[i];
        which = i;
    }
    return which;
}

/// The least t strictly between the ends at which the query's line meets the surface.
/// @param number  of the surface in its group.
std::optional<double> nearest(const BuiltShape& shape, std::uint32_t element, const Query& query,
                              const RTCRay& ray, std::uint32_t number) {
    const BuiltInstance* instance = query.instance_of(query.instID[0]);
    Line line = query.line;
    if (instance != nullptr) line = line.through(instance->placement.to_object);
    line = line.through(shape.placement().to_object);
    const auto least = [&](const auto& surface) -> std::optional<double> {
        const auto met = surface.crossings(line.origin, line.direction);
        double after = ray.tnear;
        while (true) {
            const std::uint32_t which = next_after(met, after, ray.tfar);
            if (which == kNone) return {};
            after = met.t[which];
            const Found found{&shape, instance, element, {}, after};
            if (!shape.cover() || is_there(found, query, number, which)) return after;
        }
    };
    const std::optional<double> none;
    return std::visit([&](const auto& s) { return with_exact(s, element, least, none); },
                      shape.shape());
}

/// nearest() for the primitive of a group.
std::optional<double> nearest_of(void* group_pointer, unsigned geometry, unsigned primitive,
                                 const Query& query, const RTCRay& ray) {
    const auto& group = *static_cast<const ShapeGroup*>(group_pointer);
    const ExactPrimitive& one = group.exact[primitive];
    return nearest((*group.built)[one.shape], one.element, query, ray, geometry + primitive);
}

void intersect(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto& query = *static_cast<Query*>(args->context);
    auto& found = *static_cast<RTCRayHit*>(static_cast<void*>(args->rayhit));
    const auto t = nearest_of(args->geometryUserPtr, args->geomID, args->primID, query, found.ray);
    if (!t) return;
    query.t = *t;
    found.ray.tfar = static_cast<float>(*t);
    found.hit.primID = args->primID;
    found.hit.geomID = args->geomID;
    found.hit.instID[0] = query.instID[0];
}

void occlude(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& query = *static_cast<const Query*>(args->context);
    auto& ray = *static_cast<RTCRay*>(static_cast<void*>(args->ray));
    if (nearest_of(args->geometryUserPtr, args->geomID, args->primID, query, ray))
        ray.tfar = -std::numeric_limits<float>::infinity();
}

}  // namespace

void attach_exact_shapes(ShapeGroup& group, RTCDevice device, std::uint32_t number) {
    const embree::Geometry geometry = embree::new_geometry(device, RTC_GEOMETRY_TYPE_USER);
    RTCGeometry g = geometry.get();
    rtcSetGeometryUserPrimitiveCount(g, static_cast<unsigned>(group.exact.size()));
    rtcSetGeometryUserData(g, &group);
    rtcSetGeometryBoundsFunction(g, write_bounds, nullptr);
    rtcSetGeometryIntersectFunction(g, intersect);
    rtcSetGeometryOccludedFunction(g, occlude);
    rtcCommitGeometry(g);
    rtcAttachGeometryByID(group.scene.get(), g, number);
}

}  // namespace sunfleck::engine
