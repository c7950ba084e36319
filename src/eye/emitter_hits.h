// Light that comes straight from an emitter to a vertex of a camera path: what emitters send along
// a ray, and bsdf sampling, joined with light samples (next_event_estimation.h) by multiple
// importance sampling.
//
// Source: Veach 1997, chapter 9 (power heuristic, exponent 2).
#pragma once

#include "measurement/statistics.h"
#include "scene/pass_scene.h"

#include <optional>
#include <vector>

namespace sunfleck {

/// A vertex of a camera path where a rough surface scatters.
struct EyeVertex {
    Hit hit;
    Frame frame;                   // shading
    Vec3 w_from;                   // local, unit
    const Bsdf& bsdf;              // one lane only where the path has dispersed
    MediumNumber medium = 0;       // from which the path came
    bool light_candidates = true;  // EyeSettings
};

/// Radiance that an emitter sends along a ray, and how else it could have been found.
struct EmitterMet {
    Spectrum radiance;
    float pdf = 0;  // per steradian, of a light candidate at the ray's origin, choice included
};

/// What one light has to do with a result of the functions below. Where a list of these is given,
/// they append to it; a result is the sum of its parts. Null: nobody asks.
struct LightPart {
    std::uint32_t light = 0;
    Spectrum radiance;
};
using LightParts = std::vector<LightPart>;

/// Appends a part, where anybody asks and there is any light.
void note(LightParts* parts, std::size_t light, const Spectrum& radiance);

/// Where light is wanted: what cannot come through the surface is not chosen from the tree.
Receiver receiver_at(const Scene& scene, const EyeVertex& vertex);

/// The emitter at a hit, seen along `direction` (unit, of the ray); zero if it shows its dark side
/// or is none. @param from  the vertex that the ray comes from; null: without a density.
EmitterMet emitter_at(const PassScene& pass, const Hit& hit, const Receiver* from,
                      const Vec3& direction, LightParts* parts = nullptr);

/// The infinite lights along a ray from a vertex, at `from`, that leaves the scene.
EmitterMet emitter_beyond(const PassScene& pass, const Vec3& from, const Vec3& direction,
                          LightParts* parts = nullptr);

/// Light found by following one bsdf sample from a vertex to the first thing it meets: weighted
/// for MIS with the light candidates, the sample's weight included.
Spectrum follow_bsdf_sample(const PassScene& pass, const EyeVertex& vertex, const BsdfSample& drawn,
                            Statistics& statistics, LightParts* parts = nullptr);

/// Weight of the strategy with density `mine` against one with density `other`, not both zero.
/// (By their ratio, for squares of densities need not fit into a float.)
inline float mis_weight(float mine, float other) {
    const float ratio = other / mine;
    return 1 / (1 + ratio * ratio);
}

}  // namespace sunfleck
