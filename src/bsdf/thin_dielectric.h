// A thin clear sheet, like a window pane: both its faces at one place, all echoes between them.
//
// In:  eta per wavelength, index of the sheet over that of the air on both sides. Out: two delta
// lobes, mirror and straight on. With R one face's reflectance and T = 1 - R the sheet reflects R +
// T^2 R + T^2 R^3 + ... = R + T^2 R / (1 - R^2) = 2 R / (1 + R). Nothing bends, so no wavelength
// parts from the others: it is never dispersive.
#pragma once

#include "bsdf/fresnel.h"
#include "bsdf/model.h"

namespace sunfleck::engine {

struct ThinDielectric {
    SampledSpectrum eta;  // per wavelength, positive

    static SampledSpectrum eval(const Vec3&, const Vec3&, Transport) { return {}; }
    static float pdf(const Vec3&, const Vec3&, Transport) { return 0; }

    /// Reflects when u.x lies below the mean reflectance of the wavelengths that are left. The two
    /// weights are reflectance / p and (1 - reflectance) / (1 - p), at most kWavelengths; exactly
    /// one where wavelengths do not differ or but one is left.
    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfDraw& draw) const {
        if (wo.z == 0) return {};
        const SampledSpectrum share = reflectance(std::abs(wo.z));
        const bool alike = are_alike(share, draw.hero);
        const float p = mirror_share(share, draw.hero);
        if (draw.u.x < p || p >= 1)
            return BsdfSample{alike ? SampledSpectrum(1) : share / p, Vec3(-wo.x, -wo.y, wo.z), {}};
        return BsdfSample{
            alike ? SampledSpectrum(1) : (SampledSpectrum(1) - share) / (1 - p), -wo, {}};
    }

    /// The probability with which sample() reflects.
    float mirror_share(const Vec3& wo, const HeroWavelength& hero) const {
        return mirror_share(reflectance(std::abs(wo.z)), hero);
    }

    /// What the sheet throws back, per wavelength. @param cosine  of the incident angle, in (0,1].
    SampledSpectrum reflectance(float cosine) const {
        SampledSpectrum sheet;
        for (std::size_t i = 0; i < kWavelengths; ++i) {
            const float face = dielectric_reflectance(cosine, eta[i]);
            sheet[i] = 2 * face / (1 + face);
        }
        return sheet;
    }

    /// The same of a given reflectance.
    static float mirror_share(const SampledSpectrum& share, const HeroWavelength& hero) {
        return are_alike(share, hero) ? share[hero.chosen] : share.mean();
    }

    /// Do the wavelengths that are left reflect alike?
    static bool are_alike(const SampledSpectrum& share, const HeroWavelength& hero) {
        return hero.single || share.min() == share.max();
    }

    static constexpr Scattering scattering() { return Scattering::specular; }
    static constexpr bool gathers(float, float) { return false; }
    static SampledSpectrum spread_share(const Vec3&) { return {}; }
};

}  // namespace sunfleck::engine
