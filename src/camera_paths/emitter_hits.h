// Emitter hits of camera paths: radiance of emitters along a ray, and the density with which next
// event estimation would have sampled the direction.
#pragma once

#include "scene/pass_scene.h"

#include <vector>

namespace sunfleck::engine {

/// Radiance of an emitter along a ray, with the density of the other strategy for MIS.
struct EmitterHit {
    SampledSpectrum radiance;
    float pdf = 0;  // per steradian, of a RIS candidate, choice included
};

/// The part of one light in a result of the functions below, which append to a list of these,
/// unless it is null. A result is the sum of its contributions.
struct LightContribution {
    std::uint32_t light = 0;
    SampledSpectrum radiance;
};
using LightContributions = std::vector<LightContribution>;

/// Appends a part, if there is a list and the radiance is not zero.
void note(LightContributions* contributions, std::size_t light, const SampledSpectrum& radiance);

/// Returns the emitter at a hit, seen along `direction` (unit, of the ray); zero if it emits to the
/// other side, or does not emit.
/// @param from  vertex at the origin of the ray; null for no density.
EmitterHit emitter_at(const PassScene& pass, const Hit& hit, const Receiver* from,
                      const Vec3& direction, LightContributions* contributions = nullptr);

/// Returns the infinite lights along a ray that leaves the scene, from a vertex at `from`.
EmitterHit environment_along(const PassScene& pass, const Vec3& from, const Vec3& direction,
                             LightContributions* contributions = nullptr);

}  // namespace sunfleck::engine
