// Area lights at a hit; infinite lights outside the scene.
#include "camera_paths/emitter_hits.h"

namespace sunfleck::engine {

void note(LightContributions* contributions, std::size_t light, const SampledSpectrum& radiance) {
    if (contributions != nullptr && !radiance.is_zero())
        contributions->push_back({static_cast<std::uint32_t>(light), radiance});
}

EmitterHit emitter_at(const PassScene& pass, const Hit& hit, const Receiver* from,
                      const Vec3& direction, LightContributions* contributions) {
    const std::uint32_t index = pass.scene.light_of(hit);
    if (index == kNone) return {};
    const auto& light = std::get<AreaLight>(pass.scene.lights()[index]);
    if (!light.emits(hit.normal, -direction)) return {};
    const SampledSpectrum radiance = pass.emitted(index, light, hit);
    note(contributions, index, radiance);
    if (from == nullptr) return {radiance};
    const double chosen = pass.scene.light_tree().probability(*from, index);
    return {radiance, static_cast<float>(chosen) *
                          light.direct_pdf(from->position, hit.position, hit.normal)};
}

EmitterHit environment_along(const PassScene& pass, const Vec3& from, const Vec3& direction,
                             LightContributions* contributions) {
    EmitterHit all;
    for (const std::uint32_t index : pass.scene.infinite_lights()) {
        const EnvironmentRadiance there =
            environment_radiance(pass.scene.lights()[index], from, direction);
        const SampledSpectrum radiance =
            pass.coloured(pass.emission[index] * there.factor, there.rgb);
        note(contributions, index, radiance);
        all.radiance += radiance;
        all.pdf += static_cast<float>(pass.scene.light_tree().probability({}, index)) * there.pdf;
    }
    return all;
}

}  // namespace sunfleck::engine
