// RIS candidates, which of them has a shadow ray, and the bsdf sample beside them.
#include "camera_paths/next_event_estimation.h"

#include "random_numbers/sobol.h"

#include <bit>
#include <span>

namespace sunfleck::engine {
namespace {

/// Density with which a RIS candidates takes a direction, for the weights: infinite lights lie
/// upon each other, and a bsdf sample finds them all at once, so they count together.
float density(const PassScene& pass, const Vec3& from, const LightChoice::Chosen& light,
              const DirectSample& drawn) {
    if (is_infinite(pass.scene.lights()[light.index]))
        return emitter_beyond(pass, from, drawn.direction).pdf;
    return *drawn.pdf * static_cast<float>(light.probability);
}

/// As many cells as candidates on either side of the unit square, and in each the same numbers:
/// a candidate has the sample's in another cell. Together they fill the square as a net does.
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

/// @param many  candidates.
RisCandidate candidate(const PassScene& pass, const CameraVertex& vertex,
                       const LightChoice::Chosen& choice, const Vec2d& place, float many) {
    const auto light = sample_direct(pass.scene.lights()[choice.index], vertex.hit.position,
                                     Vec2(place), pass.scene.sphere());
    if (!light) return {};
    const Vec3 wi = vertex.frame.to_local(light->direction);
    const SampledSpectrum f = eval(vertex.bsdf, vertex.wo, wi, Transport::radiance);
    if (f.is_zero()) return {};
    float weight = light->factor * std::abs(wi.z) / (many * static_cast<float>(choice.probability));
    if (light->pdf)
        weight *= mis_weight(many * density(pass, vertex.hit.position, choice, *light),
                             pdf(vertex.bsdf, vertex.wo, wi, Transport::radiance));
    return {choice.index, light->direction, light->distance,
            f * pass.tinted(pass.emission[choice.index], light->tint) * weight};
}

/// The rays to candidates of a vertex.
class ShadowRays {
public:
    ShadowRays(const PassScene& pass, const CameraVertex& vertex, Statistics& statistics,
               LightParts* parts)
        : pass_(pass), vertex_(vertex), statistics_(statistics), parts_(parts) {}

    /// What is seen of a candidate.
    /// @param by  one over the probability with which it is asked for.
    SampledSpectrum seen(const RisCandidate& light, float by) {
        ++statistics_[Count::camera_rays];
        const MediumNumber medium =
            pass_.scene.medium_beyond(vertex_.hit, light.direction, vertex_.medium);
        const SampledSpectrum found =
            light.arriving * by *
            pass_.seen_from(vertex_.hit, light.direction, light.distance, medium);
        note(parts_, light.light, found);
        return found;
    }

private:
    const PassScene& pass_;
    const CameraVertex& vertex_;
    Statistics& statistics_;
    LightParts* parts_;
};

SampledSpectrum seen_of_each(const RisCandidates& candidates, ShadowRays rays) {
    SampledSpectrum found;
    for (const RisCandidate& light : candidates)
        if (!light.arriving.is_zero()) found += rays.seen(light, 1);
    return found;
}

/// @param u  in [0,1): which is picked, in their order, so that neighbouring numbers pick alike.
SampledSpectrum seen_of_one(const RisCandidates& candidates, double u, ShadowRays rays) {
    float all = 0;
    for (const RisCandidate& light : candidates) all += light.arriving.sum();
    if (!(all > 0)) return SampledSpectrum(all);  // nothing, or no number, which pictures count
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
                              const LightNumbers& u, Statistics& statistics, LightParts* parts) {
    const RisCandidates candidates = candidates_at(pass, vertex, u);
    const ShadowRays rays(pass, vertex, statistics, parts);
    return scattering(vertex.bsdf) == Scattering::diffuse ? seen_of_each(candidates, rays)
                                                          : seen_of_one(candidates, u.pick, rays);
}

SampledSpectrum follow_bsdf_sample(const PassScene& pass, const CameraVertex& vertex,
                                   const BsdfSample& drawn, Statistics& statistics,
                                   LightParts* parts) {
    const Vec3 direction = vertex.frame.to_world(drawn.wi);
    const Scene& scene = pass.scene;
    const Receiver from = receiver_at(scene, vertex);
    SampledSpectrum sum;
    SampledSpectrum weight = drawn.weight;
    const float density_over_lights =
        drawn.pdf.value_or(1) / static_cast<float>(ris_candidates(vertex));
    std::size_t added = parts != nullptr ? parts->size() : 0;
    const auto add = [&](const EmitterMet& met) {
        if (met.radiance.is_zero()) return;
        const float mis = mis_weight(density_over_lights, met.pdf);
        sum += weight * met.radiance * mis;
        if (parts == nullptr) return;
        for (; added < parts->size(); ++added) (*parts)[added].radiance *= weight * mis;
    };
    Ray ray = ray_from(vertex.hit, direction);
    MediumNumber medium = scene.medium_beyond(vertex.hit, direction, vertex.medium);
    while (true) {
        ++statistics[Count::camera_rays];
        const auto hit = scene.geometry().intersect(ray);
        if (scene.has_media())
            weight *= pass.transmittance(medium, hit ? hit->distance : kInfinity);
        if (!hit) {
            add(emitter_beyond(pass, vertex.hit.position, direction, parts));
            return sum;
        }
        add(emitter_at(pass, *hit, &from, direction, parts));
        if (!scene.is_null_interface(*hit)) return sum;
        ray = ray_from(*hit, direction);
        medium = scene.medium_beyond(*hit, direction, medium);
    }
}

}  // namespace sunfleck::engine
