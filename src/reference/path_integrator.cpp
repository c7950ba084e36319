// One path per pixel: emission, next event estimation and bsdf sampling at every vertex, on
// surfaces and in media.
#include "reference/path_integrator.h"

#include "camera/filter.h"
#include "core/parallel.h"
#include "medium/stopping_medium.h"
#include "reference/surface.h"

#include <mutex>
#include <optional>

namespace sunfleck::engine {
namespace {

class ReferencePath {
public:
    ReferencePath(const ReferencePass& pass, RandomStream numbers, std::uint64_t& rays)
        : pass_(pass),
          scene_(pass.scene.scene),
          numbers_(numbers),
          rays_(rays),
          medium_(scene_.media().at_camera) {}

    /// Returns an estimate of the radiance along the ray.
    SampledSpectrum radiance(const CameraRay& view) {
        Ray ray{Vec3(view.origin), Vec3(view.direction)};
        last_ = ray.origin;
        std::optional<Hit> met = scene_.first_hit(view);
        hero_.chosen = hero_of(numbers_.next());
        for (int depth = 0;; ++depth) {
            auto hit = next_vertex(ray, std::move(met));
            if (!hit || depth >= pass_.transport.max_depth) return sum_;
            const auto drawn = scatter(*hit, ray);
            if (!drawn) return sum_;
            throughput_ *= drawn->weight;
            specular_ = !drawn->pdf;
            pdf_ = drawn->pdf.value_or(0);
            if (drawn->dispersed) hero_.single = true;
            scale_ *= drawn->eta * drawn->eta;
            if (depth > 2 && !survives()) return sum_;
            met = scene_.geometry().intersect(ray);
        }
    }

private:
    double number() { return numbers_.next(); }

    /// Follows the ray through null interfaces to a surface, or to where a medium scatters it, and
    /// adds the emitters on the way. @param hit  first hit of the ray, if any.
    std::optional<Hit> next_vertex(Ray& ray, std::optional<Hit> hit) {
        while (true) {
            ++rays_;
            ray.length = hit ? hit->distance : kInfinity;
            if (const auto distance = cross_medium(ray))
                return point_in_medium(ray.origin + ray.direction * *distance);
            if (!hit) {
                add_emitters_beyond(ray.direction);
                return {};
            }
            add_emitter_at(*hit, ray.direction);
            if (!scene_.is_null_interface(*hit)) return hit;
            medium_ = scene_.medium_beyond(*hit, ray.direction, medium_);
            ray = ray_from(*hit, ray.direction);
            hit = scene_.geometry().intersect(ray);
        }
    }

    /// @return the distance at which the medium scatters the path, if it does.
    std::optional<float> cross_medium(const Ray& way) {
        if (!scene_.has_media()) return {};
        const SampledMedium& medium = pass_.scene.media[medium_];
        if (medium.glow != nullptr) add_glow(medium, way);
        if (!medium.scatters) {
            throughput_ *= transmittance(medium, way);
            return {};
        }
        const Flight flight = fly(medium, way, throughput_, static_cast<float>(number()));
        throughput_ *= flight.weight;
        if (!flight.is_scattered) return {};
        return flight.distance;
    }

    /// Adds what the medium emits where a second flight is stopped, be it absorbed or scattered.
    void add_glow(const SampledMedium& medium, const Ray& way) {
        const SampledMedium stopping = stopping_medium(medium);
        const Flight flight = fly(stopping, way, throughput_, static_cast<float>(number()));
        if (!flight.is_scattered) return;
        SampledSpectrum light =
            flight.weight *
            glow_at(medium, pass_.scene.wavelengths, way.origin + way.direction * flight.distance);
        for (std::size_t i = 0; i < kWavelengths; ++i)
            light[i] *=
                stopping.scattering[i] > 0 ? medium.absorption[i] / stopping.scattering[i] : 0;
        sum_ += throughput_ * light;
    }

    void add_emitters_beyond(const Vec3& direction) {
        for (const std::uint32_t i : scene_.infinite_lights()) {
            const EnvironmentRadiance met =
                environment_radiance(scene_.lights()[i], last_, direction);
            add_emitter(i, met.pdf,
                        pass_.scene.coloured(pass_.scene.emission[i] * met.factor, met.rgb));
        }
    }

    void add_emitter_at(const Hit& hit, const Vec3& direction) {
        const std::uint32_t i = scene_.light_of(hit);
        if (i == kNone) return;
        const auto& light = std::get<AreaLight>(scene_.lights()[i]);
        if (!light.emits(hit.normal, -direction)) return;
        const float pdf = light.direct_pdf(last_, hit.position, hit.normal);
        add_emitter(i, pdf, pass_.scene.emitted(i, light, hit));
    }

    /// Adds an emitter hit by the last bsdf sample. @param light_pdf  of light samples.
    void add_emitter(std::uint32_t light, float light_pdf, const SampledSpectrum& radiance) {
        const auto other =
            static_cast<float>(scene_.light_tree().probability({last_, Vec3(0)}, light)) *
            light_pdf;
        const float weight = specular_ ? 1 : pdf_ / (pdf_ + other);
        sum_ += throughput_ * radiance * weight;
    }

    /// Adds direct light, then samples a direction: `ray` becomes the next one.
    std::optional<BsdfSample> scatter(Hit& hit, Ray& ray) {
        const Bsdf bsdf = hit.shape == kNone ? Bsdf(pass_.scene.media[medium_].phase)
                                             : vertex_bsdf(pass_.scene, hit, throughput_, hero_);
        const Frame frame(hit.shading_normal, hit.tangent);
        const Vec3 wo = frame.to_local(-ray.direction);
        if (scattering(bsdf) != Scattering::specular) add_light_sample(hit, frame, bsdf, wo);
        const BsdfSampleInput draw{{static_cast<float>(number()), static_cast<float>(number()),
                                    static_cast<float>(number())},
                                   Transport::radiance,
                                   hero_};
        auto drawn = sample(bsdf, wo, draw);
        if (drawn) ray = ray_from(hit, frame.to_world(drawn->wi));
        if (drawn) medium_ = scene_.medium_beyond(hit, ray.direction, medium_);
        last_ = hit.position;
        return drawn;
    }

    void add_light_sample(const Hit& hit, const Frame& frame, const Bsdf& bsdf, const Vec3& wo) {
        const auto choice = scene_.light_tree().choose({hit.position, Vec3(0)}, number());
        if (!choice) return;
        const Vec2 u{static_cast<float>(number()), static_cast<float>(number())};
        const auto light =
            sample_direct(scene_.lights()[choice->index], hit.position, u, scene_.sphere());
        if (!light) return;
        const Vec3 wi = frame.to_local(light->direction);
        const SampledSpectrum f = eval(bsdf, wo, wi, Transport::radiance);
        ++rays_;
        if (f.is_zero()) return;
        const MediumNumber medium = scene_.medium_beyond(hit, light->direction, medium_);
        const SampledSpectrum seen =
            pass_.scene.seen_from(hit, light->direction, light->distance, medium);
        if (seen.is_zero()) return;
        const auto chosen = static_cast<float>(choice->probability);
        float weight = 1;
        if (light->pdf) {
            const float mine = *light->pdf * chosen;
            weight = mine / (mine + pdf(bsdf, wo, wi, Transport::radiance));
        }
        const SampledSpectrum emitted =
            pass_.scene.coloured(pass_.scene.emission[choice->index], light->rgb);
        sum_ += throughput_ * f * seen * emitted *
                (light->factor * cosine_of(bsdf, wi) * weight / chosen);
    }

    bool survives() {
        const float survival = std::min(1.0F, throughput_.mean() * scale_);
        if (!(number() < static_cast<double>(survival))) return false;
        throughput_ /= survival;
        return true;
    }

    const ReferencePass& pass_;
    const Scene& scene_;
    RandomStream numbers_;
    std::uint64_t& rays_;
    MediumNumber medium_;
    SampledSpectrum sum_;
    SampledSpectrum throughput_{1};
    HeroWavelength hero_;
    bool specular_ = true;
    float pdf_ = 0;
    float scale_ = 1;
    Vec3 last_{0};  // previous vertex
};

}  // namespace

void trace_reference_paths(const ReferencePass& pass, PassImage& image, Statistics& statistics) {
    const FilterSampler filter(pass.scene.scene.filter());
    std::mutex guard;
    parallel_blocks(pass.window.pixels(), 256, [&](std::size_t begin, std::size_t end) {
        std::uint64_t rays = 0;
        for (std::size_t pixel = begin; pixel < end; ++pixel) {
            RandomStream numbers = pass.id.stream(Purpose::reference_path, pixel);
            const Vec2d u{numbers.next(), numbers.next()};
            const FilterSample filtered = filter.sample(u);
            const Vec2d film = pass.window.place(pixel, filtered.offset);
            const Vec2d lens{numbers.next(), numbers.next()};
            const CameraRay camera = camera_ray(pass.scene.scene.camera(), film, lens);
            ReferencePath path(pass, numbers, rays);
            const SampledSpectrum radiance =
                path.radiance(camera) * (filtered.weight * pass.scene.scene.film().imaging_ratio);
            image.add_light(pixel, pass.scene.wavelengths.to_rgb(radiance), Aov::total);
        }
        const std::lock_guard lock(guard);
        statistics[Count::camera_rays] += rays;
    });
}

void trace_emitters(const ReferencePass& pass, PassImage& image, Statistics& statistics) {
    TransportSettings alone = pass.transport;
    alone.max_depth = 0;
    trace_reference_paths({pass.scene, alone, pass.window, pass.id}, image, statistics);
}

}  // namespace sunfleck::engine
