// Photons in media, and where they are told to visible points.
#pragma once

#include "medium/free_path.h"
#include "photon/scattering_event.h"

namespace sunfleck::engine {

/// Leaves a photon what a medium does. @param left  factor of its flux.
/// @return whether anything is left.
inline bool keep(const SampledSpectrum& left, PhotonState& state) {
    const float before = state.flux.sum();
    state.flux *= left;
    const float kept = share_kept(before, state.flux, left);
    if (!(kept > 0)) return false;
    state.throughput *= kept;
    return true;
}

/// Samples how far a photon flies through a medium that scatters. A flight has one dimension, in a
/// block of its own beside those of scattering events.
template <PrimarySampleReader Reader>
Flight sample_flight(Reader& read, const SampledMedium& medium, const Ray& way,
                     PhotonState& state) {
    const std::uint64_t number = read(dimension(state.dimensions++, BounceDimension::lobe));
    return fly(medium, way, state.flux, to_unit_float(number));
}

/// Moves a photon to where a medium scatters it.
inline void move_on(float distance, PhotonState& state) {
    state.unlit = 0;
    state.lit_to = kInfinity;
    state.at_light = false;
    state.origin += Vec3d(state.direction) * static_cast<double>(distance);
}

inline Photon photon_at(const Hit& hit, const PhotonState& state) {
    const Vec3 normal = hit.normal.dot(state.direction) > 0 ? -hit.normal : hit.normal;
    return {hit.position, normal, -state.direction, state.bounces, state.kind, state.light_group,
            false,        1,      state.flux};
}

/// Returns a photon at the origin of its next ray, which a medium scatters there.
inline Photon photon_in_medium(const PhotonState& state) {
    return {Vec3(state.origin),
            Vec3(0),
            -state.direction,
            state.bounces,
            state.kind,
            state.light_group,
            true,
            1,
            state.flux};
}

}  // namespace sunfleck::engine
