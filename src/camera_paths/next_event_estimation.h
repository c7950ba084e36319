// Next event estimation: direct light at a vertex of a camera path, by light samples and a bsdf
// sample that multiple importance sampling joins.
//
// At a glossy surface one of several candidates, picked by what each would bring were nothing in
// the way: so the product of bsdf and light is sampled, whatever light and wherever on it, for the
// price of a ray. At a diffuse one each of two has its ray: of a pick it is not the lobe that makes
// the noise but what is in the way, most where something bright and hidden lies beside something
// dim and seen.
// Source: Veach 1997, chapter 9 (power heuristic, exponent 2); Talbot, Cline and Egbert,
// Importance resampling for global illumination (EGSR 2005).
#pragma once

#include "aovs/statistics.h"
#include "camera_paths/emitter_hits.h"

#include <array>

namespace sunfleck::engine {

/// A vertex of a camera path where a rough surface scatters.
struct CameraVertex {
    Hit hit;
    Frame frame;              // shading
    Vec3 wo;                  // local, unit
    const Bsdf& bsdf;         // one wavelength only where the path has dispersed
    MediumNumber medium = 0;  // from which the path came
    bool ris = true;          // CameraPathSettings
};

/// Where light is wanted: what cannot come through the surface is not chosen from the tree.
Receiver receiver_at(const Scene& scene, const CameraVertex& vertex);

/// Numbers in [0,1) of a vertex's light samples.
struct LightNumbers {
    double choice = 0;  // of the lights
    Vec2d place;        // on them
    double pick = 0;    // of the candidate, where one is picked
};

/// A place of a light.
struct RisCandidate {
    std::size_t light = 0;
    Vec3 direction{0};  // unit, to the light
    float distance = 0;
    /// Were nothing in the way: f * |cos| * radiance * weight / density of all candidates. None
    /// where the light cannot be seen from here.
    SampledSpectrum arriving;
};

/// How many there are: a power of two. Many where the lobe is narrow, which few places of the
/// lights fill. One where the user wants no more.
std::size_t ris_candidates(const CameraVertex& vertex);

/// As many as there are at the most; those beyond ris_candidates() have nothing arriving.
using RisCandidates = std::array<RisCandidate, 8>;
RisCandidates candidates_at(const PassScene& pass, const CameraVertex& vertex,
                            const LightNumbers& u);

/// What is seen of all candidates, or of the one that is picked over its probability.
SampledSpectrum sample_lights(const PassScene& pass, const CameraVertex& vertex,
                              const LightNumbers& u, Statistics& statistics,
                              LightParts* parts = nullptr);

/// Light found by following one bsdf sample from a vertex to the first thing it meets: weighted
/// for MIS with the RIS candidates, the sample's weight included.
SampledSpectrum follow_bsdf_sample(const PassScene& pass, const CameraVertex& vertex,
                                   const BsdfSample& drawn, Statistics& statistics,
                                   LightParts* parts = nullptr);

/// Weight of the strategy with density `mine` against one with density `other`, not both zero.
/// (By their ratio, for squares of densities need not fit into a float.)
inline float mis_weight(float mine, float other) {
    const float ratio = other / mine;
    return 1 / (1 + ratio * ratio);
}

}  // namespace sunfleck::engine
