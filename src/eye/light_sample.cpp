// Candidates, and which of them is picked.
#include "eye/light_sample.h"

#include "sampler/sobol.h"

#include <array>
#include <bit>

namespace sunfleck {
namespace {

/// Density with which a light candidate takes a direction, for the weights: infinite lights lie
/// upon each other, and a bsdf sample finds them all at once, so they count together.
float density(const PassScene& pass, const Vec3& from, const LightChoice::Chosen& light,
              const DirectSample& drawn) {
    if (is_infinite(pass.scene.lights()[light.index]))
        return emitter_beyond(pass, from, drawn.direction).pdf;
    return *drawn.pdf * static_cast<float>(light.probability);
}

/// As many cells as candidates on either side of the unit square, and in each the same numbers:
/// a candidate has the sample's in another cell. Together they fill the square as a net does.
Vec2d place_of(const Vec2d& u, unsigned number, unsigned candidates) {
    const unsigned unused = 32 - static_cast<unsigned>(std::countr_zero(candidates));
    const auto moved = [&](double x, std::size_t dimension) {
        const double at = x * candidates;
        const auto cell = static_cast<std::uint32_t>(at);
        const std::uint32_t other = cell ^ sobol(number, dimension) >> unused;
        return (other + (at - cell)) / candidates;
    };
    return {moved(u.x, 0), moved(u.y, 1)};
}

}  // namespace

unsigned light_candidates(const Bsdf& bsdf) {
    return scattering(bsdf) == Scattering::diffuse ? 2 : kMostCandidates;
}

LightCandidate light_candidate(const PassScene& pass, const EyeVertex& vertex,
                               const LightNumbers& u, unsigned number) {
    const Scene& scene = pass.scene;
    const unsigned candidates = light_candidates(vertex.bsdf);
    const auto choice =
        scene.light_tree().choose(receiver_at(scene, vertex), (number + u.choice) / candidates);
    if (!choice) return {};
    const auto light = sample_direct(scene.lights()[choice->index], vertex.hit.position,
                                     Vec2(place_of(u.place, number, candidates)), scene.sphere());
    if (!light) return {};
    const Vec3 w_to = vertex.frame.to_local(light->direction);
    const Spectrum f = eval(vertex.bsdf, vertex.w_from, w_to, Transport::radiance);
    if (f.is_zero()) return {};
    const auto many = static_cast<float>(candidates);
    float weight =
        light->factor * std::abs(w_to.z) / (many * static_cast<float>(choice->probability));
    if (light->pdf)
        weight *= mis_weight(many * density(pass, vertex.hit.position, *choice, *light),
                             pdf(vertex.bsdf, vertex.w_from, w_to, Transport::radiance));
    return {choice->index, light->direction, light->distance,
            f * pass.tinted(pass.emission[choice->index], light->tint) * weight};
}

Spectrum sample_lights(const PassScene& pass, const EyeVertex& vertex, const LightNumbers& u,
                       Statistics& statistics, LightParts* parts) {
    std::array<LightCandidate, kMostCandidates> candidates;
    std::array<float, kMostCandidates> worth{};
    float all = 0;
    const unsigned count = light_candidates(vertex.bsdf);
    for (unsigned number = 0; number < count; ++number) {
        candidates.at(number) = light_candidate(pass, vertex, u, number);
        worth.at(number) = candidates.at(number).arriving.sum();
        all += worth.at(number);
    }
    if (!(all > 0)) return Spectrum(0);
    // In their order, so that neighbouring numbers pick alike.
    unsigned picked = kMostCandidates;
    double left = u.pick * static_cast<double>(all);
    for (unsigned number = 0; number < count && left >= 0; ++number) {
        if (!(worth.at(number) > 0)) continue;
        picked = number;
        left -= static_cast<double>(worth.at(number));
    }
    const LightCandidate& light = candidates.at(picked);
    ++statistics[Count::eye_rays];
    const MediumNumber medium =
        pass.scene.medium_beyond(vertex.hit, light.direction, vertex.medium);
    const Spectrum found = light.arriving * (all / worth.at(picked)) *
                           pass.seen_from(vertex.hit, light.direction, light.distance, medium);
    if (parts != nullptr && !found.is_zero())
        parts->push_back({static_cast<std::uint32_t>(light.light), found});
    return found;
}

}  // namespace sunfleck
