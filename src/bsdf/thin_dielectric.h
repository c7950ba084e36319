// A thin clear sheet, like a window pane: both its faces at one place, all echoes between them.
//
// In:  eta per lane, index of the sheet over that of the air on both sides. Out: two delta lobes,
// mirror and straight on. With R one face's reflectance and T = 1 - R the sheet reflects
// R + T^2 R + T^2 R^3 + ... = R + T^2 R / (1 - R^2) = 2 R / (1 + R).
// Nothing bends, so no lane parts from the others: it is never dispersive.
#pragma once

#include "bsdf/fresnel.h"
#include "bsdf/model.h"

namespace sunfleck {

struct ThinDielectric {
    Spectrum eta;  // per lane, positive

    static Spectrum eval(const Vec3&, const Vec3&, Transport) { return {}; }
    static float pdf(const Vec3&, const Vec3&, Transport) { return 0; }

    /// Reflects when u.x lies below the mean reflectance of the lanes that are left. The two
    /// weights are reflectance / p and (1 - reflectance) / (1 - p), at most kLanes; exactly one
    /// where lanes do not differ or but one is left.
    std::optional<BsdfSample> sample(const Vec3& w_from, const BsdfDraw& draw) const {
        if (w_from.z == 0) return {};
        const Spectrum share = reflectance(std::abs(w_from.z));
        const bool alike = are_alike(share, draw.lanes);
        const float p = mirror_share(share, draw.lanes);
        if (draw.u.x < p || p >= 1)
            return BsdfSample{
                alike ? Spectrum(1) : share / p, Vec3(-w_from.x, -w_from.y, w_from.z), {}};
        return BsdfSample{alike ? Spectrum(1) : (Spectrum(1) - share) / (1 - p), -w_from, {}};
    }

    /// The probability with which sample() reflects.
    float mirror_share(const Vec3& w_from, const LaneChoice& lanes) const {
        return mirror_share(reflectance(std::abs(w_from.z)), lanes);
    }

    /// What the sheet throws back, per lane. @param cosine  of the incident angle, in (0,1].
    Spectrum reflectance(float cosine) const {
        Spectrum sheet;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float face = dielectric_reflectance(cosine, eta[i]);
            sheet[i] = 2 * face / (1 + face);
        }
        return sheet;
    }

    /// The same of a given reflectance.
    static float mirror_share(const Spectrum& share, const LaneChoice& lanes) {
        return are_alike(share, lanes) ? share[lanes.chosen] : share.mean();
    }

    /// Do the lanes that are left reflect alike?
    static bool are_alike(const Spectrum& share, const LaneChoice& lanes) {
        return lanes.single || share.min() == share.max();
    }

    static constexpr Scattering scattering() { return Scattering::specular; }
    static constexpr bool gathers(float, float) { return false; }
};

}  // namespace sunfleck
