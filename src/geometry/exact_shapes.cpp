// Spheres, disks and their like inside Embree: its boxes, our intersection in double.
//
// The callbacks use the world's line in double, not the float ray that Embree carries into an
// instance: t is the same in all frames, and the place on the surface is exact everywhere.
#include "geometry/built.h"
#include "geometry/cover.h"

#include <embree3/rtcore_ray.h>

#include <cmath>
#include <limits>
#include <optional>

namespace sunfleck {
namespace {

/// The float next to x, and a little more, in the direction of `sign`.
float outwards(double x, double size, double sign) {
    return static_cast<float>(x + sign * (std::abs(x) + size) * 0x1p-20);
}

void write_bounds(const RTCBoundsFunctionArguments* args) {
    const auto& group = *static_cast<const ShapeGroup*>(args->geometryUserPtr);
    const Bounds& box = (*group.built)[group.exact[args->primID]].bounds();
    const double size = box.radius();
    args->bounds_o->lower_x = outwards(box.min.x, size, -1);
    args->bounds_o->lower_y = outwards(box.min.y, size, -1);
    args->bounds_o->lower_z = outwards(box.min.z, size, -1);
    args->bounds_o->upper_x = outwards(box.max.x, size, 1);
    args->bounds_o->upper_y = outwards(box.max.y, size, 1);
    args->bounds_o->upper_z = outwards(box.max.z, size, 1);
}

/// The least t strictly between the ends at which the query's line meets the shape.
std::optional<double> nearest(const BuiltShape& shape, const Query& query, const RTCRay& ray,
                              std::uint32_t geometry, std::uint32_t primitive) {
    const BuiltInstance* instance = query.instance_of(query.instID[0]);
    Line line = query.line;
    if (instance != nullptr) line = line.through(instance->placement.to_object);
    line = line.through(shape.placement().to_object);
    const Crossings met = std::visit(
        [&](const auto& s) -> Crossings {
            if constexpr (ExactShape<std::decay_t<decltype(s)>>)
                return s.crossings(line.origin, line.direction);
            else
                return {};
        },
        shape.shape());
    for (std::uint32_t i = 0; i < 2; ++i) {
        if (!(met.on.at(i) && met.t.at(i) > ray.tnear && met.t.at(i) < ray.tfar)) continue;
        const Found found{&shape, instance, primitive, {}, met.t.at(i)};
        if (!shape.cover() || is_there(found, query, geometry, i)) return met.t.at(i);
    }
    return {};
}

const BuiltShape& shape_of(void* group_pointer, unsigned primitive) {
    const auto& group = *static_cast<const ShapeGroup*>(group_pointer);
    return (*group.built)[group.exact[primitive]];
}

void intersect(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto& query = *static_cast<Query*>(args->context);
    auto& found = *static_cast<RTCRayHit*>(static_cast<void*>(args->rayhit));
    const auto t = nearest(shape_of(args->geometryUserPtr, args->primID), query, found.ray,
                           args->geomID, args->primID);
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
    if (nearest(shape_of(args->geometryUserPtr, args->primID), query, ray, args->geomID,
                args->primID))
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

}  // namespace sunfleck
