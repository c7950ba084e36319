// RIS candidates, the choice of the one with a shadow ray, and the bsdf sample.
#include "camera_paths/next_event_estimation.h"

#include "random_numbers/sobol.h"

#include <bit>
#include <span>

namespace sunfleck::engine {
namespace {

/// Returns the density of a direction under RIS candidates, for MIS weights. Infinite lights
/// overlap, and a bsdf sample finds all of them at once, so their densities are added.
float density(const PassScene& pass, const Vec3& from, const LightChoice::Chosen& light,
              const DirectSample& drawn) {
    if (is_infinite(pass.scene.lights()[light.index]))
        return environment_along(pass, from, drawn.direction).pdf;
    return *drawn.pdf * static_cast<float>(light.probability);
}

/// Divides the unit square into as many cells as candidates. A candidate has the position of the
/// sample in another cell, so that together they are stratified.
Vec2d place_of(const Vec2d& u, std::size_t number, std::size_t candidates) {
    const int unused = 32 - std::countr_zero(candidates);
    const auto moved = [&](double x, std::size_t dimension) {
        const double at = x * static_cast<double>(candidates);
        const auto cell = static_cast<std::uint32_t>(at);
        const std::uint32_t other =
            cell ^
            static_cast<std::uint32_t>(
                std::uint64_t{sobol(static_cast<std::uint32_t>(number), dimension)} >> unused);
        return (other + (at - cell)) / static_cast<double>(candidates);
    };
    return {moved(u.x, 0), moved(u.y, 1)};
}

/// @param many  number of candidates.
RisCandidate candidate(const PassScene& pass, const CameraVertex& vertex,
                       const LightChoice::Chosen& choice, const Vec2d& place, float many) {
    const auto light = sample_direct(pass.scene.lights()[choice.index], vertex.hit.position,
                                     Vec2(place), pass.scene.sphere());
    if (!light) return {};
    const Vec3 wi = vertex.frame.to_local(light->direction);
    const SampledSpectrum f = eval(vertex.bsdf, vertex.wo, wi, Transport::radiance);
    if (f.is_zero()) return {};
    float weight = light->factor * cosine_of(vertex.bsdf, wi) /
                   (many * static_cast<float>(choice.probability));
    if (light->pdf)
        weight *= mis_weight(many * density(pass, vertex.hit.position, choice, *light),
                             pdf(vertex.bsdf, vertex.wo, wi, Transport::radiance));
    return {choice.index, light->direction, light->distance,
            f * pass.coloured(pass.emission[choice.index], light->rgb) * weight};
}

/// Shadow rays to the candidates of a vertex.
class ShadowRays {
public:
    ShadowRays(const PassScene& pass, const CameraVertex& vertex, Statistics& statistics,
               LightContributions* contributions)
        : pass_(pass), vertex_(vertex), statistics_(statistics), contributions_(contributions) {}

    /// Returns the visible contribution of a candidate.
    /// @param by  one over the probability of its choice.
    SampledSpectrum seen(const RisCandidate& light, float by) {
        ++statistics_[Count::camera_rays];
        const MediumNumber medium =
            pass_.scene.medium_beyond(vertex_.hit, light.direction, vertex_.medium);
        const SampledSpectrum found =
            light.arriving * by *
            pass_.seen_from(vertex_.hit, light.direction, light.distance, medium);
        note(contributions_, light.light, found);
        return found;
    }

private:
    const PassScene& pass_;
    const CameraVertex& vertex_;
    Statistics& statistics_;
    LightContributions* contributions_;
};

SampledSpectrum seen_of_each(const RisCandidates& candidates, ShadowRays rays) {
    SampledSpectrum found;
    for (const RisCandidate& light : candidates)
        if (!light.arriving.is_zero()) found += rays.seen(light, 1);
    return found;
}

/// @param u  in [0,1): selects the candidate in list order, so that neighbouring numbers select
/// alike.
SampledSpectrum seen_of_one(const RisCandidates& candidates, double u, ShadowRays rays) {
    float all = 0;
    for (const RisCandidate& light : candidates) all += light.arriving.sum();
    if (!(all > 0)) return SampledSpectrum(all);  // zero, or NaN, which pictures count
    const RisCandidate* picked = nullptr;
    double left = u * static_cast<double>(all);
    for (const RisCandidate& light : candidates) {
        const float worth = light.arriving.sum();
        if (!(worth > 0)) continue;
        picked = &light;
        left -= static_cast<double>(worth);
        if (left < 0) break;
    }
    return rays.seen(*picked, all / picked->arriving.sum());
}

}  // namespace

Receiver receiver_at(const Scene& scene, const CameraVertex& vertex) {
    if (!scene.light_tree().is_grown() || gathers(vertex.bsdf, 1, -1))
        return {vertex.hit.position, Vec3(0)};
    return {vertex.hit.position, vertex.wo.z < 0 ? -vertex.frame.z : vertex.frame.z};
}

std::size_t ris_candidates(const CameraVertex& vertex) {
    if (!vertex.ris) return 1;
    return scattering(vertex.bsdf) == Scattering::diffuse ? 2 : 8;
}

RisCandidates candidates_at(const PassScene& pass, const CameraVertex& vertex,
                            const LightNumbers& u) {
    RisCandidates candidates;
    const std::size_t count = ris_candidates(vertex);
    const auto many = static_cast<double>(count);
    std::array<double, candidates.size()> numbers{};
    for (std::size_t i = 0; i < count; ++i)
        numbers.at(i) = (static_cast<double>(i) + u.choice) / many;
    std::array<std::optional<LightChoice::Chosen>, candidates.size()> chosen;
    pass.scene.light_tree().choose_each(receiver_at(pass.scene, vertex),
                                        std::span(numbers).first(count),
                                        std::span(chosen).first(count));
    for (std::size_t i = 0; i < count; ++i)
        if (chosen.at(i))
            candidates.at(i) = candidate(pass, vertex, *chosen.at(i), place_of(u.place, i, count),
                                         static_cast<float>(many));
    return candidates;
}

SampledSpectrum sample_lights(const PassScene& pass, const CameraVertex& vertex,
                              const LightNumbers& u, Statistics& statistics,
                              LightContributions* contributions) {
    const RisCandidates candidates = candidates_at(pass, vertex, u);
    const ShadowRays rays(pass, vertex, statistics, contributions);
    return scattering(vertex.bsdf) == Scattering::diffuse ? seen_of_each(candidates, rays)
                                                          : seen_of_one(candidates, u.pick, rays);
}

SampledSpectrum follow_bsdf_sample(const PassScene& pass, const CameraVertex& vertex,
                                   const BsdfSample& drawn, Statistics& statistics,
                                   LightContributions* contributions) {
    const Vec3 direction = vertex.frame.to_world(drawn.wi);
    const Scene& scene = pass.scene;
    const Receiver from = receiver_at(scene, vertex);
    SampledSpectrum sum;
    SampledSpectrum weight = drawn.weight;
    const float density_over_lights =
        drawn.pdf.value_or(1) / static_cast<float>(ris_candidates(vertex));
    std::size_t added = contributions != nullptr ? contributions->size() : 0;
    const auto add = [&](const EmitterHit& met) {
        if (met.radiance.is_zero()) return;
        const float mis = mis_weight(density_over_lights, met.pdf);
        sum += weight * met.radiance * mis;
        if (contributions == nullptr) return;
        for (; added < contributions->size(); ++added)
            (*contributions)[added].radiance *= weight * mis;
    };
    Ray ray = ray_from(vertex.hit, direction);
    MediumNumber medium = scene.medium_beyond(vertex.hit, direction, vertex.medium);
    while (true) {
        ++statistics[Count::camera_rays];
        const auto hit = scene.geometry().intersect(ray);
        if (scene.has_media())
            weight *= pass.transmittance(medium,
                                         {ray.origin, direction, hit ? hit->distance : kInfinity});
        if (!hit) {
            add(environment_along(pass, vertex.hit.position, direction, contributions));
            return sum;
        }
        add(emitter_at(pass, *hit, &from, direction, contributions));
        if (!scene.is_null_interface(*hit)) return sum;
        ray = ray_from(*hit, direction);
        medium = scene.medium_beyond(*hit, direction, medium);
    }
}

}  // namespace sunfleck::engine
