// Emitters that are met, and bsdf samples that meet them.
#include "eye/emitter_hits.h"

#include "eye/next_event_estimation.h"

namespace sunfleck {
void note(LightParts* parts, std::size_t light, const Spectrum& radiance) {
    if (parts != nullptr && !radiance.is_zero())
        parts->push_back({static_cast<std::uint32_t>(light), radiance});
}

Receiver receiver_at(const Scene& scene, const EyeVertex& vertex) {
    if (!scene.light_tree().is_grown() || gathers(vertex.bsdf, 1, -1))
        return {vertex.hit.position, Vec3(0)};
    return {vertex.hit.position, vertex.w_from.z < 0 ? -vertex.frame.z : vertex.frame.z};
}

EmitterMet emitter_at(const PassScene& pass, const Hit& hit, const Receiver* from,
                      const Vec3& direction, LightParts* parts) {
    const std::uint32_t index = pass.scene.light_of(hit);
    if (index == kNone) return {};
    const auto& light = std::get<AreaLight>(pass.scene.lights()[index]);
    if (!light.emits(hit.normal, -direction)) return {};
    const Spectrum radiance = pass.emitted(index, light, hit);
    note(parts, index, radiance);
    if (from == nullptr) return {radiance};
    const double chosen = pass.scene.light_tree().probability(*from, index);
    return {radiance, static_cast<float>(chosen) *
                          light.direct_pdf(from->position, hit.position, hit.normal)};
}

EmitterMet emitter_beyond(const PassScene& pass, const Vec3& from, const Vec3& direction,
                          LightParts* parts) {
    EmitterMet all;
    for (const std::uint32_t index : pass.scene.infinite_lights()) {
        const Beyond there = beyond(pass.scene.lights()[index], from, direction);
        const Spectrum radiance = pass.tinted(pass.emission[index] * there.factor, there.tint);
        note(parts, index, radiance);
        all.radiance += radiance;
        all.pdf += static_cast<float>(pass.scene.light_tree().probability({}, index)) * there.pdf;
    }
    return all;
}

Spectrum follow_bsdf_sample(const PassScene& pass, const EyeVertex& vertex, const BsdfSample& drawn,
                            Statistics& statistics, LightParts* parts) {
    const Vec3 direction = vertex.frame.to_world(drawn.w_to);
    const Scene& scene = pass.scene;
    const Receiver from = receiver_at(scene, vertex);
    Spectrum sum;
    Spectrum weight = drawn.weight;
    const float density_over_lights =
        drawn.pdf.value_or(1) / static_cast<float>(light_candidates(vertex));
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
        ++statistics[Count::eye_rays];
        const auto hit = scene.geometry().intersect(ray);
        if (scene.has_media()) weight *= pass.left_after(medium, hit ? hit->distance : kInfinity);
        if (!hit) {
            add(emitter_beyond(pass, vertex.hit.position, direction, parts));
            return sum;
        }
        add(emitter_at(pass, *hit, &from, direction, parts));
        if (!scene.passes_straight(*hit)) return sum;
        ray = ray_from(*hit, direction);
        medium = scene.medium_beyond(*hit, direction, medium);
    }
}

}  // namespace sunfleck
