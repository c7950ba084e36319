// InitialGuideSamples: emission whose light reaches a given point, as primary samples.
//
// In:  a point of the scene, random numbers. Out: a light sample, whether it arrives, and the
// primary sample of a photon that takes its way. Glass is passed straight on the way to a light:
// the result is a guide sample for the emission guide (guide/emission_guide.h) and no part of a
// picture.
#pragma once

#include "core/random.h"
#include "photon/light_stratum.h"
#include "random_numbers/emission_point.h"

#include <optional>

namespace sunfleck::engine {

inline constexpr int kMostPanes = 32;  // surfaces passed on one way

/// The unoccluded contribution of a light sample at a point.
struct LightAtPoint {
    std::size_t light;
    double probability;  // of selecting that light
    DirectSample direct;
};

class InitialGuideSamples {
public:
    InitialGuideSamples(const PassScene& scene, const LightChoice& lights)
        : scene_(scene), lights_(lights) {}

    /// Selects a light by power, and a point or direction of it.
    std::optional<LightAtPoint> sample(const Vec3& at, RandomStream& stream) const;
    /// Returns the number of surfaces that light passes along the ray, straight as if glass were
    /// flat.
    /// @param distance  to the light. @return -1 if it is blocked.
    int panes_to(Ray ray, float distance) const;
    /// Returns the emission of a light; a light that is dark at the wavelengths of the pass counts
    /// as grey, because guide samples are used in other passes, too. It is weighted by luminance
    /// over power.
    SampledSpectrum emitted_by(std::size_t light) const;
    /// Returns the emission of light that arrives so. @param weight  of the guide sample.
    /// @return nothing if no primary sample leads there, or if the weight is not positive.
    std::optional<WeightedEmission> guide_sample(const LightAtPoint& sample, const Vec3& at,
                                                 double weight, RandomStream& stream) const;

private:
    bool is_clear(Hit& hit, const Vec3& direction) const;

    const PassScene& scene_;
    const LightChoice& lights_;
};

}  // namespace sunfleck::engine
