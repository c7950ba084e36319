// Hints at emission that may be visible: light that reaches a point, as the numbers that emit it.
//
// In:  a point of the scene, random numbers. Out: a sample of a light, whether it arrives, and the
// primary sample of a photon that would take its way. Glass is passed straight on the way to a
// light: what is found is a guide sample for emission guide (guide/emission_guide.h) and no part of
// a picture.
#pragma once

#include "core/random.h"
#include "photon/light_stratum.h"
#include "random_numbers/emission_point.h"

#include <optional>

namespace sunfleck::engine {

inline constexpr int kMostPanes = 32;  // surfaces passed on one way

/// What of a light's sample would arrive at a point, were nothing in the way.
struct LightAtPoint {
    std::size_t light;
    double probability;  // of choosing that light
    DirectSample direct;
};

class InitialGuideSamples {
public:
    InitialGuideSamples(const PassScene& scene, const LightChoice& lights)
        : scene_(scene), lights_(lights) {}

    /// A light, chosen by power, and a point or direction of it.
    std::optional<LightAtPoint> sample(const Vec3& at, RandomStream& stream) const;
    /// Surfaces that light passes along the ray, straight as if glass were flat.
    /// @param distance  to the light. @return -1: it is stopped.
    int panes_to(Ray ray, float distance) const;
    /// The emission that arrives so. @param weight  of the guide sample.
    /// @return nothing where no numbers lead there, or the weight is not positive.
    std::optional<WeightedEmission> guide_sample(const LightAtPoint& sample, const Vec3& at,
                                                 double weight, RandomStream& stream) const;

private:
    bool is_clear(Hit& hit, const Vec3& direction) const;

    const PassScene& scene_;
    const LightChoice& lights_;
};

}  // namespace sunfleck::engine
