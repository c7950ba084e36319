// Where photons start: on a light, or in a medium that emits.
#pragma once

#include "aovs/transport.h"
#include "photon/scattering_event.h"
#include "scene/pass_scene.h"

#include <optional>

namespace sunfleck::engine {

/// Returns whether a photon that nothing has scattered yet comes from the glow of a medium: no
/// light sample brings its light to where it arrives first.
inline bool is_of_medium(const PhotonState& state) {
    return state.kind == PhotonKind::indirect;
}

/// Reads the depth in a medium from which a photon starts: one dimension, in a block of its own
/// beside those of scattering events.
template <PrimarySampleReader Reader>
double depth_of_start(Reader& read, PhotonState& state) {
    return to_unit(read(dimension(state.dimensions++, BounceDimension::lobe)));
}

/// Samples the light and the first ray; sets flux, direction, medium and kind. @param lights  in
/// which paths start. @return nothing if nothing is emitted there.
template <PrimarySampleReader Reader>
std::optional<Emission> emit(Reader& read, const PassScene& pass,
                             const TransportSettings& transport, const LightChoice& lights,
                             PhotonState& state) {
    const auto unit = [&](EmissionDimension which) { return to_unit(read(dimension(which))); };
    if (lights.empty()) return {};
    const auto choice = lights.choose(unit(EmissionDimension::light));
    const bool has_media = pass.scene.has_media();
    const Light& light = pass.scene.lights()[choice.index];
    const auto* of_medium = has_media ? std::get_if<MediumLight>(&light) : nullptr;
    Emission start =
        sample_emission(light,
                        {unit(EmissionDimension::position_u), unit(EmissionDimension::position_v),
                         unit(EmissionDimension::direction_u), unit(EmissionDimension::direction_v),
                         of_medium != nullptr ? depth_of_start(read, state) : 0},
                        pass.scene.sphere());
    if (!(start.factor > 0)) return {};  // from a black texel of an image
    state.light_group = transport.light_groups.of(choice.index);
    const Vec3d normal(start.normal);
    start.origin += normal * (normal.dot(start.direction) < 0 ? -start.error : start.error);
    const auto factor = static_cast<float>(start.factor / choice.probability);
    state.flux = pass.emission[choice.index] * factor;
    if (start.rgb) state.flux = pass.coloured(state.flux, start.rgb);
    if (of_medium != nullptr) {
        const auto glow = pass.glow_at(*of_medium, Vec3(start.origin));
        if (!glow) return {};
        state.flux = *glow * factor;
        state.kind = PhotonKind::indirect;
    }
    if (has_media) state.medium = pass.start_medium(choice.index, start, state.flux);
    state.direction = Vec3(start.direction);
    return start;
}

}  // namespace sunfleck::engine
