// Lambertian reflection: radiance leaves evenly in all directions of the side that is lit.
//
// In:  directions in the local frame (bsdf/model.h). Out: f = albedo / pi, on both sides alike.
// Source: Lambert, Photometria (1760); cosine sampling by Malley's method.
#pragma once

#include "bsdf/model.h"
#include "math/float_disc.h"

namespace sunfleck {

struct Lambert {
    Spectrum albedo;  // per lane, in [0,1]

    Spectrum eval(const Vec3& w_from, const Vec3& w_to, Transport) const {
        return gathers(w_from.z, w_to.z) ? albedo / kPi : Spectrum();
    }

    float pdf(const Vec3& w_from, const Vec3& w_to, Transport) const {
        return gathers(w_from.z, w_to.z) ? std::abs(w_to.z) / kPi : 0;
    }

    [[gnu::always_inline]] inline std::optional<BsdfSample> sample(const Vec3& w_from,
                                                                   const BsdfDraw& draw) const {
        const FloatDiscPoint disc = float_disc_point({draw.u.y, draw.u.z});
        // The floor keeps u at the very edge of the square from leaving along the surface.
        const float height = std::sqrt(std::max(1e-8F, disc.height2));
        const Vec3 w_to(disc.position.x, disc.position.y, std::copysign(height, w_from.z));
        return BsdfSample{albedo, w_to, height / kPi};
    }

    static constexpr Scattering scattering() { return Scattering::diffuse; }
    /// Light must arrive on the side that is looked at.
    static bool gathers(float z_from, float z_to) { return z_from * z_to > 0; }
};

}  // namespace sunfleck
