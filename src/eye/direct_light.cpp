// Next-event estimation and bsdf sampling of emitters.
#include "eye/direct_light.h"

namespace sunfleck {
namespace {

/// Density with which light samples take a direction, for the weights: infinite lights lie upon
/// each other, and a bsdf sample finds them all at once, so they count together.
float density(const PassScene& pass, std::size_t light, const DirectSample& drawn,
              float probability) {
    if (is_infinite(pass.scene.lights()[light])) return emitter_beyond(pass, drawn.direction).pdf;
    return *drawn.pdf * probability;
}

}  // namespace

Spectrum sample_lights(const PassScene& pass, const EyeVertex& vertex, double u_choice,
                       const Vec2d& u, Statistics& statistics) {
    const Scene& scene = pass.scene;
    if (scene.light_choice().empty()) return Spectrum(0);
    const auto choice = scene.light_choice().choose(u_choice);
    const auto light =
        sample_direct(scene.lights()[choice.index], vertex.hit.position, Vec2(u), scene.sphere());
    if (!light) return Spectrum(0);
    const Vec3 w_to = vertex.frame.to_local(light->direction);
    const Spectrum f = eval(vertex.bsdf, vertex.w_from, w_to, Transport::radiance);
    if (f.is_zero()) return f;
    ++statistics[Count::eye_rays];
    const MediumNumber medium = scene.medium_beyond(vertex.hit, light->direction, vertex.medium);
    const Spectrum seen = pass.seen_from(vertex.hit, light->direction, light->distance, medium);
    if (seen.is_zero()) return seen;
    const auto probability = static_cast<float>(choice.probability);
    float weight = light->factor * std::abs(w_to.z) / probability;
    if (light->pdf)
        weight *= mis_weight(density(pass, choice.index, *light, probability),
                             pdf(vertex.bsdf, vertex.w_from, w_to, Transport::radiance));
    return f * seen * pass.tinted(pass.emission[choice.index], light->tint) * weight;
}

EmitterMet emitter_at(const PassScene& pass, const Hit& hit, const Vec3& from,
                      const Vec3& direction) {
    const std::uint32_t index = pass.scene.light_of(hit);
    if (index == kNone) return {};
    const auto& light = std::get<AreaLight>(pass.scene.lights()[index]);
    if (!light.emits(hit.normal, -direction)) return {};
    const double chosen = pass.scene.light_choice().probability(index);
    return {pass.emission[index],
            static_cast<float>(chosen) * light.direct_pdf(from, hit.position, hit.normal)};
}

EmitterMet emitter_beyond(const PassScene& pass, const Vec3& direction) {
    EmitterMet all;
    for (const std::uint32_t index : pass.scene.infinite_lights()) {
        const Beyond there = beyond(pass.scene.lights()[index], direction);
        all.radiance += pass.tinted(pass.emission[index] * there.factor, there.tint);
        all.pdf += static_cast<float>(pass.scene.light_choice().probability(index)) * there.pdf;
    }
    return all;
}

Spectrum follow_bsdf_sample(const PassScene& pass, const EyeVertex& vertex, const BsdfSample& drawn,
                            Statistics& statistics) {
    const Vec3 direction = vertex.frame.to_world(drawn.w_to);
    const Scene& scene = pass.scene;
    Spectrum sum;
    Spectrum weight = drawn.weight;
    const auto add = [&](const EmitterMet& met) {
        if (!met.radiance.is_zero())
            sum += weight * met.radiance * mis_weight(drawn.pdf.value_or(1), met.pdf);
    };
    Ray ray = ray_from(vertex.hit, direction);
    MediumNumber medium = scene.medium_beyond(vertex.hit, direction, vertex.medium);
    while (true) {
        ++statistics[Count::eye_rays];
        const auto hit = scene.geometry().intersect(ray);
        if (scene.has_media()) weight *= pass.left_after(medium, hit ? hit->distance : kInfinity);
        if (!hit) {
            add(emitter_beyond(pass, direction));
            return sum;
        }
        add(emitter_at(pass, *hit, vertex.hit.position, direction));
        if (!scene.passes_straight(*hit)) return sum;
        ray = ray_from(*hit, direction);
        medium = scene.medium_beyond(*hit, direction, medium);
    }
}

}  // namespace sunfleck
