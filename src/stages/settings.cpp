// The text that says whether two renders may be merged: one "name=value" a line.
#include "stages/settings.h"

#include "film/pass_weight.h"
#include "photon_samplers/samplers.h"

#include <fmt/format.h>

namespace sunfleck::engine {

void use_paper_mode(RenderSettings& settings) {
    settings.photon.sampler = PhotonSampler::paper;
    settings.transport.direct = DirectLight::photons;
    settings.alpha = 0.7;
    settings.camera.indirect_radius = 1;
    settings.camera.edges = false;
    if (!settings.camera.radius_pixels) settings.camera.radius_pixels = 2;
}

std::uint64_t small_passes(const RenderSettings& settings, std::size_t pixels) {
    const bool has_photons = settings.integrator == Integrator::sppm;
    const bool starts_small =
        has_photons && !is_sequential(settings) && pixels >= settings.large_picture;
    return starts_small ? kSmallPasses : 0;
}

bool is_sequential(const RenderSettings& settings) {
    return settings.integrator == Integrator::sppm && has_state(settings.photon.sampler);
}

std::string RenderSettings::text() const {
    const auto optional_number = [](const auto& value) {
        return value ? fmt::format("{}", *value) : std::string("default");
    };
    std::string text = fmt::format(
        "integrator={}\nphoton_sampler={}\ndirect={}\nmax_depth={}\nphotons_per_pass={}\n"
        "radius_pixels={}\nradius={}\nindirect_radius={}\nalpha={}\n",
        name_of(integrator), name_of(photon.sampler),
        transport.direct == DirectLight::sampled ? "sampled" : "photons", transport.max_depth,
        optional_number(photon.paths_per_pass), optional_number(camera.radius_pixels),
        optional_number(camera.radius), optional_number(camera.indirect_radius), alpha);
    if (energy_compensation) text += "energy_compensation=on\n";
    if (integrator == Integrator::sppm && transport.direct == DirectLight::sampled)
        text += fmt::format("indirect={}\n", name_of(transport.indirect));
    if (!camera.edges) text += "edges=off\n";
    if (!camera.ris) text += "ris=off\n";
    if (objective != Objective::relative) text += fmt::format("objective={}\n", name_of(objective));
    for (const AdaptivePart& part : kAdaptiveParts)
        if (!(photon.*part.is_on)) text += setting_of(part) + "=off\n";
    if (!transport.light_groups.names.empty())
        text += fmt::format("output_light_groups={}\n", transport.light_groups.text);
    return text + sampler_settings_text(photon);
}

}  // namespace sunfleck::engine
