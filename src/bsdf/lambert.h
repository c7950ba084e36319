// Lambert: diffuse reflection, with constant radiance on the side that is lit.
//
// In:  directions in the local frame (bsdf/model.h). Out: f = albedo / pi, the same on both sides.
// Source: Lambert, Photometria (1760); cosine sampling by Malley's method.
#pragma once

#include "bsdf/model.h"
#include "math/float_disc.h"

namespace sunfleck::engine {

struct Lambert {
    SampledSpectrum albedo;  // per wavelength, in [0,1]

    SampledSpectrum eval(const Vec3& wo, const Vec3& wi, Transport) const {
        return gathers(wo.z, wi.z) ? albedo / kPi : SampledSpectrum();
    }

    float pdf(const Vec3& wo, const Vec3& wi, Transport) const {
        return gathers(wo.z, wi.z) ? std::abs(wi.z) / kPi : 0;
    }

    [[gnu::always_inline]] inline std::optional<BsdfSample> sample(
        const Vec3& wo, const BsdfSampleInput& draw) const {
        const FloatDiscPoint disc = float_disc_point({draw.u.y, draw.u.z});
        // The lower bound keeps directions from the edge of the square off the surface's plane.
        const float height = std::sqrt(std::max(1e-8F, disc.height2));
        const Vec3 wi(disc.position.x, disc.position.y, std::copysign(height, wo.z));
        return BsdfSample{albedo, wi, height / kPi};
    }

    static constexpr Scattering scattering() { return Scattering::diffuse; }
    /// Returns whether both directions are on the same side.
    static bool gathers(float z_from, float z_to) { return z_from * z_to > 0; }
    SampledSpectrum diffuse_albedo(const Vec3&) const { return albedo; }
    static constexpr float reflection_probability(const Vec3&, const HeroWavelength&) { return 0; }
};

}  // namespace sunfleck::engine
