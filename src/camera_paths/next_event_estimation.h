// Next event estimation: direct light at a vertex of a camera path, by light samples and a bsdf
// sample combined by MIS.
//
// A glossy vertex uses resampled importance sampling: one of several candidates is picked in
// proportion to its unoccluded contribution, so that the product of bsdf and light is sampled for
// the price of one shadow ray. A diffuse vertex traces a shadow ray for each of two light samples,
// because occlusion, not the lobe, dominates the noise of a pick, most where a bright hidden light
// is next to a dim visible one.
// Source: Veach 1997, chapter 9 (power heuristic, exponent 2); Talbot, Cline and Egbert, Importance
// resampling for global illumination (EGSR 2005).
#pragma once

#include "aovs/statistics.h"
#include "camera_paths/emitter_hits.h"

#include <array>

namespace sunfleck::engine {

/// A vertex of a camera path at a surface that is not specular, or in a medium.
struct CameraVertex {
    Hit hit;
    Frame frame;              // shading frame
    Vec3 wo;                  // local, unit
    const Bsdf& bsdf;         // of one wavelength if the others are terminated
    MediumNumber medium = 0;  // medium of the path before the vertex
    bool ris = true;          // see CameraPathSettings
};

/// Returns the receiver for the light tree, which excludes light that cannot pass the surface.
Receiver receiver_at(const Scene& scene, const CameraVertex& vertex);

/// Random numbers in [0,1) for the light samples of a vertex.
struct LightNumbers {
    double choice = 0;  // selects the lights
    Vec2d place;        // selects points on them
    double pick = 0;    // selects the candidate, if one is picked
};

/// A candidate: a point on a light.
struct RisCandidate {
    std::size_t light = 0;
    Vec3 direction{0};  // unit, to the light
    float distance = 0;
    /// Unoccluded contribution: f * |cos| * radiance * weight / density of all candidates. Zero if
    /// the light cannot be seen from here.
    SampledSpectrum arriving;
};

/// Returns the number of candidates, a power of two: many if the lobe is narrow and covers few of
/// the lights' points; one if RIS is off.
std::size_t ris_candidates(const CameraVertex& vertex);

/// The largest number of candidates; those beyond ris_candidates() contribute zero.
using RisCandidates = std::array<RisCandidate, 8>;
RisCandidates candidates_at(const PassScene& pass, const CameraVertex& vertex,
                            const LightNumbers& u);

/// Returns the visible contribution of all candidates, or of one picked over its probability.
SampledSpectrum sample_lights(const PassScene& pass, const CameraVertex& vertex,
                              const LightNumbers& u, Statistics& statistics,
                              LightContributions* contributions = nullptr);

/// Returns the light found by tracing one bsdf sample from a vertex to its first hit, with MIS
/// weights against the RIS candidates; the weight of the sample is included.
SampledSpectrum follow_bsdf_sample(const PassScene& pass, const CameraVertex& vertex,
                                   const BsdfSample& drawn, Statistics& statistics,
                                   LightContributions* contributions = nullptr);

/// Returns the MIS weight (power heuristic) of the strategy with density `mine` against one with
/// density `other`, not both zero. It uses their ratio, because squared densities may overflow.
inline float mis_weight(float mine, float other) {
    const float ratio = other / mine;
    return 1 / (1 + ratio * ratio);
}

}  // namespace sunfleck::engine
