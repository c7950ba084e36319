// Radiance that emitters send along a ray of a camera path, and the density with which next event
// estimation would have sampled the same direction.
#pragma once

#include "scene/pass_scene.h"

#include <vector>

namespace sunfleck::engine {

/// Radiance that an emitter sends along a ray, and how else it could have been found.
struct EmitterMet {
    SampledSpectrum radiance;
    float pdf = 0;  // per steradian, of a RIS candidates at the ray's origin, choice included
};

/// What one light has to do with a result of the functions below. Where a list of these is given,
/// they append to it; a result is the sum of its parts. Null: nobody asks.
struct LightPart {
    std::uint32_t light = 0;
    SampledSpectrum radiance;
};
using LightParts = std::vector<LightPart>;

/// Appends a part, where anybody asks and there is any light.
void note(LightParts* parts, std::size_t light, const SampledSpectrum& radiance);

/// The emitter at a hit, seen along `direction` (unit, of the ray); zero if it shows its dark side
/// or is none. @param from  the vertex that the ray comes from; null: without a density.
EmitterMet emitter_at(const PassScene& pass, const Hit& hit, const Receiver* from,
                      const Vec3& direction, LightParts* parts = nullptr);

/// The infinite lights along a ray from a vertex, at `from`, that leaves the scene.
EmitterMet emitter_beyond(const PassScene& pass, const Vec3& from, const Vec3& direction,
                          LightParts* parts = nullptr);

}  // namespace sunfleck::engine
