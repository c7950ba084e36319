// One path from a light, with a connection of every vertex to the camera, added to all pixels whose
// filter covers the point.
#include "reference/light_integrator.h"

#include "camera/projection.h"
#include "core/parallel.h"
#include "reference/splatter.h"
#include "reference/surface.h"

#include <mutex>

namespace sunfleck::engine {
namespace {

class LightPath {
public:
    LightPath(const ReferencePass& pass, const Projection& camera, const Splatter& splatter,
              RandomStream numbers, std::uint64_t& rays)
        : pass_(pass),
          scene_(pass.scene.scene),
          camera_(camera),
          splatter_(splatter),
          numbers_(numbers),
          rays_(rays) {}

    /// @param share  weight of this path: one over their number.
    /// @return whether it contributed to a pixel.
    bool trace(float share) {
        follow(share);
        return seen_;
    }

private:
    void follow(float share) {
        hero_.chosen = hero_of(number());
        const Emission start = emit(share);
        auto unlit = static_cast<float>(start.unlit);
        auto lit_to = static_cast<float>(start.lit_to);
        direction_ = Vec3(start.direction);
        const Vec3d normal(start.normal);
        const Vec3d origin =
            start.origin + normal * (normal.dot(start.direction) < 0 ? -start.error : start.error);
        Hit hit;
        Vec3 from(origin);
        RayHit met = scene_.geometry().trace_precise(origin, start.direction);
        for (int depth = 0; depth < pass_.transport.max_depth;) {
            ++rays_;
            if (!scene_.geometry().complete(met, hit)) return;
            const bool is_lit = !(hit.distance < unlit || hit.distance > lit_to);
            unlit -= hit.distance;
            lit_to -= hit.distance;
            if (scene_.has_media())
                flux_ *= pass_.scene.transmittance(medium_, {from, direction_, hit.distance});
            if (!scene_.is_null_interface(hit)) {
                if (!is_lit) return;
                if (!scatter(hit, depth)) return;
                lit_to = kInfinity;
                ++depth;
            }
            medium_ = scene_.medium_beyond(hit, direction_, medium_);
            const Ray ray = ray_from(hit, direction_);
            from = ray.origin;
            met = scene_.geometry().trace(ray);
        }
    }

    double number() { return numbers_.next(); }
    Vec2d two_numbers() {
        const double first = number();
        return {first, number()};
    }

    Emission emit(float share) {
        const auto choice = scene_.light_choice().choose(number());
        const Vec2d place = two_numbers();
        const Vec2d way = two_numbers();
        Emission start = sample_emission(scene_.lights()[choice.index],
                                         {place.x, place.y, way.x, way.y}, scene_.sphere());
        flux_ = pass_.scene.coloured(pass_.scene.emission[choice.index], start.rgb) *
                (share * static_cast<float>(start.factor / choice.probability));
        medium_ = pass_.scene.start_medium(choice.index, start, flux_);
        return start;
    }

    /// Connects to the camera, then samples a direction. @return whether the path continues.
    bool scatter(Hit& hit, int depth) {
        const Bsdf bsdf = vertex_bsdf(pass_.scene, hit, flux_, hero_);
        const Frame frame(hit.shading_normal, hit.tangent);
        const Vec3 wo = frame.to_local(-direction_);
        // Flux per area refers to the geometric surface, bsdfs to the shading normal.
        const float arrived = std::abs(wo.z / direction_.dot(hit.normal));
        if (scattering(bsdf) != Scattering::specular) look(hit, frame, bsdf, wo, arrived);
        const BsdfSampleInput draw{{static_cast<float>(number()), static_cast<float>(number()),
                                    static_cast<float>(number())},
                                   Transport::flux,
                                   hero_};
        const auto drawn = sample(bsdf, wo, draw);
        if (!drawn) return false;
        direction_ = frame.to_world(drawn->wi);
        const float left = std::abs(direction_.dot(hit.normal) / drawn->wi.z);
        const SampledSpectrum before = flux_;
        flux_ *= drawn->weight * (arrived * left);
        if (drawn->dispersed) hero_.single = true;
        return depth < 3 || survives(before);
    }

    void look(const Hit& hit, const Frame& frame, const Bsdf& bsdf, const Vec3& wo, float arrived) {
        const auto sight = camera_.sight_of(Vec3d(hit.position), two_numbers());
        if (!sight || !splatter_.reaches(sight->film)) return;
        const Vec3 way = Vec3(sight->origin) - hit.position;
        const float distance = way.length();
        if (!(distance > 0)) return;
        const Vec3 to_camera = way / distance;
        const SampledSpectrum f = eval(bsdf, wo, frame.to_local(to_camera), Transport::flux);
        if (f.is_zero()) return;
        ++rays_;
        const MediumNumber medium = scene_.medium_beyond(hit, to_camera, medium_);
        const SampledSpectrum seen = pass_.scene.seen_from(hit, to_camera, distance, medium);
        if (seen.is_zero()) return;
        const float facing = std::abs(to_camera.dot(hit.normal));
        seen_ = true;
        splatter_.add(sight->film,
                      flux_ * f * seen * (arrived * facing * static_cast<float>(sight->area)));
    }

    bool survives(const SampledSpectrum& before) {
        const float survival = std::min(1.0F, flux_.sum() / before.sum());
        if (!(number() < static_cast<double>(survival))) return false;
        flux_ /= survival;
        return true;
    }

    const ReferencePass& pass_;
    const Scene& scene_;
    const Projection& camera_;
    const Splatter& splatter_;
    RandomStream numbers_;
    std::uint64_t& rays_;
    SampledSpectrum flux_;
    Vec3 direction_{0};
    MediumNumber medium_ = 0;
    HeroWavelength hero_;
    bool seen_ = false;
};

}  // namespace

void trace_light_paths(const ReferencePass& pass, std::uint32_t paths, PassImage& image,
                       Statistics& statistics) {
    trace_emitters(pass, image, statistics);
    if (pass.scene.scene.light_choice().empty()) return;
    statistics[Count::uniform_paths] += paths;
    const Projection camera(pass.scene.scene.camera());
    const Splatter splatter(pass, image);
    std::mutex guard;
    parallel_blocks(paths, 1024, [&](std::size_t begin, std::size_t end) {
        std::uint64_t rays = 0;
        std::uint64_t seen = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const RandomStream numbers = pass.id.stream(Purpose::light_path, i);
            LightPath path(pass, camera, splatter, numbers, rays);
            seen += path.trace(1 / static_cast<float>(paths)) ? 1 : 0;
        }
        const std::lock_guard lock(guard);
        statistics[Count::photon_rays] += rays;
        statistics[Count::uniform_visible] += seen;
    });
}

}  // namespace sunfleck::engine
