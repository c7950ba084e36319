// A polished metal: a mirror on both sides, coloured by its complex index.
//
// In:  eta + i k per lane, over the index of air. Out: one delta lobe.
#pragma once

#include "bsdf/fresnel.h"
#include "bsdf/model.h"

namespace sunfleck {

struct SmoothConductor {
    Spectrum eta;
    Spectrum k;

    static Spectrum eval(const Vec3&, const Vec3&, Transport) { return {}; }
    static float pdf(const Vec3&, const Vec3&, Transport) { return 0; }

    std::optional<BsdfSample> sample(const Vec3& w_from, const BsdfDraw&) const {
        if (w_from.z == 0) return {};
        return BsdfSample{conductor_reflectance(std::abs(w_from.z), eta, k),
                          Vec3(-w_from.x, -w_from.y, w_from.z),
                          {}};
    }

    static constexpr Scattering scattering() { return Scattering::specular; }
    static constexpr bool gathers(float, float) { return false; }
};

}  // namespace sunfleck
