// Next-event estimation: one light sample from a vertex of a camera path.
//
// It is one of several candidates, picked by what each would bring were nothing in the way: so the
// product of bsdf and light is sampled, whatever light and wherever on it, for the price of a ray.
// Source: Talbot, Cline and Egbert, Importance resampling for global illumination (EGSR 2005).
#pragma once

#include "eye/direct_light.h"

namespace sunfleck {

/// Numbers in [0,1) of one light sample.
struct LightNumbers {
    double choice = 0;  // of the lights
    Vec2d place;        // on them
    double pick = 0;    // of the candidate
};

/// Candidates of a light sample, a power of two, at most kMostCandidates: many where the lobe is
/// narrow, which few places of the lights fill; of a wide one fewer, for among many what is bright
/// and hidden is picked where something dim is seen.
unsigned light_candidates(const Bsdf& bsdf);
inline constexpr unsigned kMostCandidates = 8;

/// A place of a light.
struct LightCandidate {
    std::size_t light = 0;
    Vec3 direction{0};  // unit, to the light
    float distance = 0;
    /// Were nothing in the way: f * |cos| * radiance * weight / density of all candidates.
    Spectrum arriving;
};

/// @param number  of light_candidates(). @return what no light comes from has nothing arriving.
LightCandidate light_candidate(const PassScene& pass, const EyeVertex& vertex,
                               const LightNumbers& u, unsigned number);

/// One light sample, from a candidate that is picked: what comes from there over the probability.
Spectrum sample_lights(const PassScene& pass, const EyeVertex& vertex, const LightNumbers& u,
                       Statistics& statistics, LightParts* parts = nullptr);

}  // namespace sunfleck
