// Recording rays by replaying a pass, and tracing them with Embree alone.
#include "raw_embree.h"

#include "core/parallel.h"
#include "math/warp.h"
#include "photon/tracer.h"
#include "render/pass.h"
#include "sampler/emission_points.h"

#include <embree3/rtcore_ray.h>

#include <atomic>

namespace sunfleck::bench {
namespace {

constexpr std::size_t kBlock = 1024;

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

Vec3 emission_origin(const Scene& scene, EmissionPoints::Reader read) {
    const auto unit = [&](EmissionSlot which) { return to_unit(read(slot(which))); };
    const auto choice = scene.light_choice().choose(unit(EmissionSlot::light));
    const Emission start =
        sample_emission(scene.lights()[choice.index],
                        {unit(EmissionSlot::position_u), unit(EmissionSlot::position_v),
                         unit(EmissionSlot::direction_u), unit(EmissionSlot::direction_v)},
                        scene.sphere());
    return Vec3(start.origin) + Vec3(start.normal) * static_cast<float>(start.error);
}

}  // namespace

RawEmbree::RawEmbree(const Scene& scene) : device_(embree::open_device("avx2")) {
    const GeometryInput& input = scene.geometry().input();
    std::size_t most = 0;
    for (const PlacedShape& shape : input.shapes)
        if (const auto* mesh = std::get_if<TriangleMesh>(&shape.shape))
            most = std::max(most, mesh->triangles.size());
    for (std::uint32_t i = 0; i < most; ++i) counting_.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    for (const PlacedShape& shape : input.shapes)
        shapes_.emplace_back(shape, device_.get(), counting_);
    world_.built = &shapes_;
    world_.shapes = input.in_world;
    world_.attach(device_.get(), static_cast<std::uint32_t>(shapes_.size()));
    embree::commit(world_.scene.get());
}

std::size_t RawEmbree::trace_block(const RecordedRay* begin, const RecordedRay* end) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    std::size_t hits = 0;
    for (const RecordedRay* r = begin; r != end; ++r) {
        if (r->shadow) {
            RTCRay ray = embree_ray(r->ray);
            rtcOccluded1(world_.scene.get(), &context, &ray);
            hits += ray.tfar < 0 ? 1 : 0;
        } else {
            RTCRayHit met{embree_ray(r->ray), {}};
            met.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            met.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(world_.scene.get(), &context, &met);
            hits += met.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
        }
    }
    return hits;
}

std::size_t RawEmbree::trace(const std::vector<RecordedRay>& rays) const {
    std::atomic<std::size_t> hits{0};
    parallel_blocks(rays.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        hits += trace_block(&rays[begin], rays.data() + end);
    });
    return hits;
}

std::vector<RecordedRay> photon_rays(const Scene& scene, std::uint32_t paths, PassId pass) {
    const PassScene at_wavelengths(scene, pass);
    const TransportSettings transport;
    const PhotonTracer tracer(at_wavelengths, transport);
    const EmissionPoints points(pass);
    const auto error = static_cast<float>(scene.sphere().radius) * 1e-6F;
    std::vector<RecordedRay> rays;
    for (std::uint32_t i = 0; i < paths; ++i) {
        Vec3 origin = emission_origin(scene, points.path(i));
        Vec3 normal(0);
        std::uint64_t count = 0;
        const auto visit = [&](const Photon& photon) {
            const Vec3 direction = -photon.w;
            rays.push_back({{offset_origin(origin, normal, error, direction), direction}, false});
            origin = photon.position;
            normal = photon.normal;
            return true;
        };
        tracer.trace(points.path(i), visit, count);
    }
    return rays;
}

std::vector<RecordedRay> eye_rays(const Scene& scene, PassId pass) {
    std::vector<RecordedRay> rays;
    const PixelWindow window = window_of(scene.film());
    for (std::size_t i = 0; i < window.pixels(); ++i) {
        const auto width = static_cast<std::size_t>(window.width());
        const Vec2d film(static_cast<double>(i % width) + 0.5,
                         static_cast<double>(i / width) + 0.5);
        const CameraRay start = camera_ray(scene.camera(), film, {0.5, 0.5});
        const Ray ray{Vec3(start.origin), Vec3(start.direction)};
        rays.push_back({ray, false});
        const auto hit = scene.geometry().intersect(ray);
        if (!hit) continue;
        RandomStream numbers = pass.stream(Purpose::test, static_cast<std::uint32_t>(i));
        const auto draw = [&] { return to_unit(numbers.next_fraction()); };
        const auto choice = scene.light_choice().choose(draw());
        const double u = draw();
        const auto light = sample_direct(scene.lights()[choice.index], hit->position,
                                         Vec2(Vec2d(u, draw())), scene.sphere());
        if (light) rays.push_back({shadow_ray(*hit, light->direction, light->distance), true});
        const bool back = hit->normal.dot(ray.direction) > 0;
        const Frame frame(back ? -hit->normal : hit->normal, hit->tangent);
        const double v = draw();
        const Vec3 local(cosine_hemisphere({v, draw()}));
        rays.push_back({ray_from(*hit, frame.to_world(local)), false});
    }
    return rays;
}

}  // namespace sunfleck::bench
