// Area lights at a hit; infinite lights beyond the scene.
#include "camera_paths/emitter_hits.h"

namespace sunfleck::engine {

void note(LightParts* parts, std::size_t light, const SampledSpectrum& radiance) {
    if (parts != nullptr && !radiance.is_zero())
        parts->push_back({static_cast<std::uint32_t>(light), radiance});
}

EmitterMet emitter_at(const PassScene& pass, const Hit& hit, const Receiver* from,
                      const Vec3& direction, LightParts* parts) {
    const std::uint32_t index = pass.scene.light_of(hit);
    if (index == kNone) return {};
    const auto& light = std::get<AreaLight>(pass.scene.lights()[index]);
    if (!light.emits(hit.normal, -direction)) return {};
    const SampledSpectrum radiance = pass.emitted(index, light, hit);
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
        const SampledSpectrum radiance =
            pass.tinted(pass.emission[index] * there.factor, there.tint);
        note(parts, index, radiance);
        all.radiance += radiance;
        all.pdf += static_cast<float>(pass.scene.light_tree().probability({}, index)) * there.pdf;
    }
    return all;
}

}  // namespace sunfleck::engine
