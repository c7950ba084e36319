// Construction of a geometry, and ray tracing.
#include "geometry/geometry.h"

#include "geometry/attach.h"
#include "geometry/built.h"
#include "geometry/complete_hit.h"
#include "geometry/derivatives_at.h"
#include "geometry/extent.h"
#include "geometry/query.h"

#include <embree3/rtcore_ray.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <map>

namespace sunfleck::engine {
namespace {

/// The smallest t of a hit: hits at t = 0 do not count.
constexpr float kNearest = std::numeric_limits<float>::min();

/// Returns the float before `length`, because Embree includes hits at the end.
float last_before(float length) {
    return length * 0x1.fffffep-1F;
}

using FourFloats [[gnu::vector_size(16)]] = float;

/// Writes four floats at once, as Embree reads them; mixed store sizes would stall the processor.
void set_ray(RTCRay& ray, const Line& line, float length) {
    const Vec3 origin(line.origin);
    const Vec3 direction(line.direction);
    const FourFloats start{origin.x, origin.y, origin.z, kNearest};
    const FourFloats way{direction.x, direction.y, direction.z, 0};
    std::memcpy(&ray.org_x, &start, sizeof(start));
    std::memcpy(&ray.dir_x, &way, sizeof(way));
    ray.tfar = last_before(length);
    ray.mask = 0xFFFFFFFF;
    ray.id = 0;
    ray.flags = 0;
}

bool is_traceable(const Line& line, float length) {
    const double size =
        absolute_dot(line.origin, Vec3d(1)) + absolute_dot(line.direction, Vec3d(1));
    return size < kLargestExtent && length > 0 && line.direction != Vec3d(0);
}

}  // namespace

struct Geometry::Impl {
    GeometryInput input;
    embree::Device device;
    std::vector<BuiltShape::Corners> counting;    // index buffer of Embree for all meshes
    std::vector<BuiltShape> shapes;               // as in the input; only those that are used
    std::map<std::uint32_t, ShapeGroup> objects;  // by object index
    std::vector<BuiltInstance> instances;
    ShapeGroup world;
    Bounds bounds;
    std::size_t triangles = 0;

    Impl(GeometryInput in, const std::string& isa);

    void build_shapes();
    void build_objects();
    void build_world();
    std::uint32_t first_instance() const { return static_cast<std::uint32_t>(world.shapes.size()); }
    std::size_t triangles_of(const std::vector<std::uint32_t>& list) const;
    RayHit trace(const Line& ray, double walked, float length, AlphaTest alpha_test) const;
    void complete(const RayHit& ray_hit, Hit& hit) const;
    double empty_way(const Line& ray) const;
    bool is_far(double distance, const Vec3& position) const;
};

Geometry::Impl::Impl(GeometryInput in, const std::string& isa)
    : input(std::move(in)), device(embree::open_device(isa)) {
    build_shapes();
    build_objects();
    build_world();
    triangles = triangles_of(input.in_world);
    for (const PlacedInstance& instance : input.instances)
        triangles += triangles_of(instance.shapes);
}

void Geometry::Impl::build_shapes() {
    std::vector<char> is_used(input.shapes.size(), 0);
    for (const std::uint32_t s : input.in_world) is_used[s] = 1;
    for (const PlacedInstance& instance : input.instances)
        for (const std::uint32_t s : instance.shapes) is_used[s] = 1;
    shapes.resize(input.shapes.size());
    std::size_t most = 0;
    for (const PlacedShape& shape : input.shapes)
        if (const auto* mesh = std::get_if<TriangleMesh>(&shape.shape))
            most = std::max(most, mesh->triangles.size());
    counting.resize(most);
    for (std::uint32_t i = 0; i < most; ++i) counting[i] = {3 * i, 3 * i + 1, 3 * i + 2};
    for (std::size_t i = 0; i < shapes.size(); ++i)
        if (is_used[i] != 0) shapes[i] = BuiltShape(input.shapes[i], device.get(), counting);
}

void Geometry::Impl::build_objects() {
    for (const PlacedInstance& instance : input.instances) {
        const auto [place, is_new] = objects.try_emplace(instance.object);
        ShapeGroup& object = place->second;
        if (!is_new) continue;
        object.built = &shapes;
        object.shapes = instance.shapes;
        attach_shapes(object, device.get(), static_cast<std::uint32_t>(object.shapes.size()));
        embree::commit(object.scene.get());
    }
}

void Geometry::Impl::build_world() {
    world.built = &shapes;
    world.shapes = input.in_world;
    const std::size_t exact_number = input.in_world.size() + input.instances.size();
    attach_shapes(world, device.get(), static_cast<std::uint32_t>(exact_number));
    bounds = world.bounds;
    instances.reserve(input.instances.size());
    for (const PlacedInstance& placed : input.instances) {
        const auto number = first_instance() + static_cast<std::uint32_t>(instances.size());
        const BuiltInstance& instance =
            instances.emplace_back(placed.to_world, objects.at(placed.object), device.get());
        if (!instance.geometry) continue;
        rtcAttachGeometryByID(world.scene.get(), instance.geometry.get(), number);
        bounds.extend(instance.bounds());
    }
    embree::commit(world.scene.get());
}

std::size_t Geometry::Impl::triangles_of(const std::vector<std::uint32_t>& list) const {
    std::size_t sum = 0;
    for (const std::uint32_t s : list)
        if (const auto* mesh = std::get_if<TriangleMesh>(&input.shapes[s].shape))
            sum += mesh->triangles.size();
    return sum;
}

/// @param walked  ray parameter at which the trace begins. @param length  from there.
RayHit Geometry::Impl::trace(const Line& ray, double walked, float length,
                             AlphaTest alpha_test) const {
    RayHit ray_hit;
    ray_hit.alpha_test = alpha_test;
    ray_hit.origin = ray.origin;
    ray_hit.direction = ray.direction;
    ray_hit.walked = walked;
    if (!is_traceable(ray, length)) return ray_hit;
    Query query(ray, walked, instances, first_instance());
    query.alpha_test = alpha_test;
    RTCRayHit met;
    set_ray(met.ray, query.line, length);
    met.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    met.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(world.scene.get(), &query, &met);
    if (met.hit.geomID == RTC_INVALID_GEOMETRY_ID) return ray_hit;

    const bool in_world = met.hit.instID[0] == RTC_INVALID_GEOMETRY_ID;
    ray_hit.instance = in_world ? kNone : met.hit.instID[0] - first_instance();
    const ShapeGroup& group = in_world ? world : *instances[ray_hit.instance].group;
    const ExactPrimitive named = group.named(met.hit.geomID, met.hit.primID);
    ray_hit.shape = named.shape;
    ray_hit.primitive = named.element;
    ray_hit.weights = {met.hit.u, met.hit.v};
    ray_hit.t = query.t;
    const BuiltShape& met_shape = shapes[ray_hit.shape];
    if (met_shape.is_plain() || met_shape.mesh() != nullptr) {
        __builtin_prefetch(met_shape.corner_floats(ray_hit.primitive));
        __builtin_prefetch(met_shape.corner_floats(ray_hit.primitive) + 8);
        if (!met_shape.is_plain()) __builtin_prefetch(&met_shape.corners(ray_hit.primitive));
    }
    return ray_hit;
}

void Geometry::Impl::complete(const RayHit& ray_hit, Hit& hit) const {
    const BuiltInstance* instance =
        ray_hit.instance == kNone ? nullptr : &instances[ray_hit.instance];
    complete_hit(
        {&shapes[ray_hit.shape], instance, ray_hit.primitive, Vec2d(ray_hit.weights), ray_hit.t},
        Line{ray_hit.origin, ray_hit.direction}.from(ray_hit.walked), hit);
    hit.shape = ray_hit.shape;
    hit.instance = ray_hit.instance;
}

/// Returns the distance that a ray can skip before it may hit anything, if it starts so far away
/// that floats along it are coarse (boxes would look thicker, and most would be opened). Zero for
/// other rays, and never beyond the scene's bounding sphere.
double Geometry::Impl::empty_way(const Line& ray) const {
    constexpr double kOutside = 0x1p10;
    const double radius = bounds.radius();
    const double to_middle = (bounds.center() - ray.origin).dot(ray.direction);
    return to_middle > kOutside * radius ? to_middle * (1 - 0x1p-40) - 1.01 * radius : 0;
}

/// Returns whether a hit is far: float precision at the hit is finer than what remains after that
/// distance. Distances that are short for the scene are not worth a second trace.
bool Geometry::Impl::is_far(double distance, const Vec3& p) const {
    const double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return distance > 64 * size && distance > 0x1p-9 * bounds.radius();
}

Geometry::Geometry(GeometryInput input, const std::string& isa)
    : impl_(std::make_shared<const Impl>(std::move(input), isa)) {}

RayHit Geometry::trace(const Ray& ray, AlphaTest alpha_test) const {
    return impl_->trace({Vec3d(ray.origin), Vec3d(ray.direction)}, 0, ray.length, alpha_test);
}

RayHit Geometry::trace_precise(const Vec3d& origin, const Vec3d& direction,
                               AlphaTest alpha_test) const {
    const Line ray{origin, direction};
    RayHit ray_hit = impl_->trace(ray, impl_->empty_way(ray), kInfinity, alpha_test);
    ray_hit.precise = true;
    return ray_hit;
}

/// A float ray from 10 km away misses its target by half a millimetre: its origin lies on a grid of
/// 2^-11 m, and its direction is exact to 2^-24. So the first trace finds the distance, and the
/// next one starts a thousandth of that before the surface, from a point computed in double: the
/// remaining distance is short, and so are the errors. The position of the hit is computed from the
/// line in double anyway; the repetition corrects which primitive is hit. If that hit is far again
/// (the first one was spurious), the trace is repeated, at most three times. A thin object more
/// than a thousandth of the distance before the hit is lost.
bool Geometry::complete(const RayHit& ray_hit, Hit& hit) const {
    constexpr int kMostRepetitions = 3;
    constexpr double kWalk = 1 - 0x1p-10;
    if (ray_hit.shape == kNone) return false;
    impl_->complete(ray_hit, hit);
    if (!ray_hit.precise) return true;
    const Line ray{ray_hit.origin, ray_hit.direction};
    double walked = ray_hit.walked;
    for (int repetition = 0; repetition < kMostRepetitions; ++repetition) {
        const double left = hit.distance;
        hit.distance = static_cast<float>(walked + left);
        if (!impl_->is_far(left, hit.position)) return true;
        walked += left * kWalk;
        const RayHit again = impl_->trace(ray, walked, kInfinity, ray_hit.alpha_test);
        if (again.shape == kNone) return false;
        impl_->complete(again, hit);
    }
    hit.distance = static_cast<float>(walked + double{hit.distance});
    return true;
}

bool Geometry::is_there(const Hit& hit, const Vec3d& origin, const Vec3& direction) const {
    const Cover& cover = impl_->shapes[hit.shape].cover();
    return !cover || passes_alpha_test(cover(hit), origin, Vec3d(direction),
                                       {hit.shape, hit.primitive, hit.instance});
}

std::optional<Hit> Geometry::intersect(const Ray& ray) const {
    std::optional<Hit> hit(std::in_place);
    if (!complete(trace(ray), *hit)) hit.reset();
    return hit;
}

std::optional<Hit> Geometry::intersect_precise(const Vec3d& origin, const Vec3d& direction) const {
    std::optional<Hit> hit(std::in_place);
    if (!complete(trace_precise(origin, direction), *hit)) hit.reset();
    return hit;
}

SurfaceDerivatives Geometry::derivatives(const Hit& hit) const {
    const BuiltInstance* instance =
        hit.instance == kNone ? nullptr : &impl_->instances[hit.instance];
    return derivatives_at(impl_->shapes[hit.shape], instance, hit);
}

bool Geometry::occluded(const Ray& ray) const {
    const Line line{Vec3d(ray.origin), Vec3d(ray.direction)};
    if (!is_traceable(line, ray.length)) return false;
    Query query(line, 0, impl_->instances, impl_->first_instance());
    RTCRay embree;
    set_ray(embree, line, ray.length);
    rtcOccluded1(impl_->world.scene.get(), &query, &embree);
    return embree.tfar < 0;
}

const Bounds& Geometry::bounds() const {
    return impl_->bounds;
}
const GeometryInput& Geometry::input() const {
    return impl_->input;
}
std::size_t Geometry::triangle_count() const {
    return impl_->triangles;
}

}  // namespace sunfleck::engine
