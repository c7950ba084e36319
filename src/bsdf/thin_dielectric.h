// ThinDielectric: a thin clear sheet (window pane), both faces at one place, with all
// interreflections.
//
// In:  eta per wavelength, index of the sheet over that of the air on both sides; the colour of
// what passes. Out: two delta lobes, mirror reflection and straight transmission. With R the
// reflectance of one face and T = 1 - R, the sheet reflects R + T^2 R + T^2 R^3 + ... = R + T^2 R /
// (1 - R^2) = 2 R / (1 + R). Directions do not depend on the wavelength, so the sheet is never
// dispersive.
#pragma once

#include "bsdf/fresnel.h"
#include "bsdf/model.h"

namespace sunfleck::engine {

struct ThinDielectric {
    SampledSpectrum eta;                          // per wavelength, positive
    SampledSpectrum colour = SampledSpectrum(1);  // of what passes; at most 1

    static SampledSpectrum eval(const Vec3&, const Vec3&, Transport) { return {}; }
    static float pdf(const Vec3&, const Vec3&, Transport) { return 0; }

    /// Reflects if u.x is below the mean reflectance of the remaining wavelengths. The two weights
    /// are reflectance / p and colour * (1 - reflectance) / (1 - p), at most kWavelengths; exactly
    /// one and the colour if all wavelengths agree or one remains.
    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfSampleInput& draw) const {
        if (wo.z == 0) return {};
        const SampledSpectrum share = reflectance(std::abs(wo.z));
        const bool alike = are_alike(share, draw.hero);
        const float p = reflection_probability(share, draw.hero);
        if (draw.u.x < p || p >= 1)
            return BsdfSample{alike ? SampledSpectrum(1) : share / p, Vec3(-wo.x, -wo.y, wo.z), {}};
        return BsdfSample{
            alike ? colour : colour * (SampledSpectrum(1) - share) / (1 - p), -wo, {}};
    }

    /// Returns the probability with which sample() reflects.
    float reflection_probability(const Vec3& wo, const HeroWavelength& hero) const {
        return reflection_probability(reflectance(std::abs(wo.z)), hero);
    }

    /// Returns the reflectance of the sheet per wavelength. @param cosine  of the incident angle,
    /// in (0,1].
    SampledSpectrum reflectance(float cosine) const {
        SampledSpectrum sheet;
        for (std::size_t i = 0; i < kWavelengths; ++i) {
            const float face = dielectric_reflectance(cosine, eta[i]);
            sheet[i] = 2 * face / (1 + face);
        }
        return sheet;
    }

    /// Returns the probability of reflection for a given reflectance.
    static float reflection_probability(const SampledSpectrum& share, const HeroWavelength& hero) {
        return are_alike(share, hero) ? share[hero.chosen] : share.mean();
    }

    /// Returns whether the remaining wavelengths have the same reflectance.
    static bool are_alike(const SampledSpectrum& share, const HeroWavelength& hero) {
        return hero.single || share.min() == share.max();
    }

    static constexpr Scattering scattering() { return Scattering::specular; }
    static constexpr bool gathers(float, float) { return false; }
    static SampledSpectrum diffuse_albedo(const Vec3&) { return {}; }
};

}  // namespace sunfleck::engine
