// SmoothDielectric: a smooth boundary between clear media, which reflects and refracts by Fresnel.
//
// In:  eta per wavelength, index inside (side -z) over outside (side +z). Out: two delta lobes.
// Source: Fresnel's and Snell's laws; radiance scales by the squared ratio of indices at a
// refraction (Veach 1997, section 5.2). Dispersion: docs/method/method.md, hero wavelength.
#pragma once

#include "bsdf/fresnel.h"
#include "bsdf/model.h"

namespace sunfleck::engine {

class SmoothDielectric {
public:
    /// @param eta  positive in all wavelengths; 1 transmits without deflection.
    explicit SmoothDielectric(const SampledSpectrum& eta)
        : eta_(eta), dispersive_(eta.min() != eta.max()) {}

    static SampledSpectrum eval(const Vec3&, const Vec3&, Transport) { return {}; }
    static float pdf(const Vec3&, const Vec3&, Transport) { return 0; }

    /// Reflects if u.x is below the reflectance. If the glass is dispersive and no wavelength is
    /// kept yet, reflection keeps all wavelengths and refraction keeps draw.hero.chosen alone.
    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfSampleInput& draw) const {
        if (wo.z == 0) return {};
        if (dispersive_ && !draw.hero.single) return sample_wavelengths(wo, draw);
        const Crossing crossing = cross(wo, eta_[draw.hero.chosen]);
        if (draw.u.x < crossing.reflectance || crossing.cos_far == 0)
            return BsdfSample{SampledSpectrum(1), mirrored(wo), {}};
        return refracted(wo, crossing, SampledSpectrum(crossing.scale(draw.transport)));
    }

    /// Returns the probability with which sample() reflects.
    float reflection_probability(const Vec3& wo, const HeroWavelength& hero) const {
        if (wo.z == 0) return 0;
        if (dispersive_ && !hero.single) return reflectances(wo).mean();
        const Crossing crossing = cross(wo, eta_[hero.chosen]);
        return crossing.cos_far == 0 ? 1 : crossing.reflectance;
    }

    static constexpr Scattering scattering() { return Scattering::specular; }
    static constexpr bool gathers(float, float) { return false; }
    static SampledSpectrum diffuse_albedo(const Vec3&) { return {}; }

    const SampledSpectrum& eta() const { return eta_; }
    bool is_dispersive() const { return dispersive_; }
    SmoothDielectric at_wavelength(std::size_t wavelength) const {
        return SmoothDielectric(SampledSpectrum(eta_[wavelength]));
    }

private:
    /// Reflection and refraction of one wavelength.
    struct Crossing {
        float eta;  // index of the far side over that of the near side
        float cos_far;
        float reflectance;

        float scale(Transport t) const { return t == Transport::radiance ? 1 / (eta * eta) : 1; }
    };

    static Crossing cross(const Vec3& wo, float inside) {
        const float eta = wo.z > 0 ? inside : 1 / inside;
        const float sin2 = wo.x * wo.x + wo.y * wo.y;
        const float cos_far = refracted_cosine(sin2, eta);
        return {eta, cos_far, dielectric_reflectance(std::abs(wo.z), cos_far, eta)};
    }

    static Vec3 mirrored(const Vec3& w) { return {-w.x, -w.y, w.z}; }

    static BsdfSample refracted(const Vec3& w, const Crossing& c, const SampledSpectrum& weight) {
        const Vec3 wi(-w.x / c.eta, -w.y / c.eta, std::copysign(c.cos_far, -w.z));
        return {weight, wi, {}, c.eta};
    }

    SampledSpectrum reflectances(const Vec3& wo) const {
        SampledSpectrum reflectance;
        for (std::size_t i = 0; i < kWavelengths; ++i)
            reflectance[i] = cross(wo, eta_[i]).reflectance;
        return reflectance;
    }

    /// Reflects with the mean probability p over wavelengths, with weights F / p <= kWavelengths.
    /// Refraction keeps one wavelength c, uniform over wavelengths, with weight kWavelengths (1 -
    /// F_c) / (1 - p), so that the mean over c and u.x is 1 - F in every wavelength. Under total
    /// reflection of wavelength c that weight is zero, and nothing is returned.
    std::optional<BsdfSample> sample_wavelengths(const Vec3& wo,
                                                 const BsdfSampleInput& draw) const {
        const SampledSpectrum reflectance = reflectances(wo);
        const float p = reflectance.mean();
        if (draw.u.x < p || p >= 1) return BsdfSample{reflectance / p, mirrored(wo), {}};

        const std::size_t wavelength = draw.hero.chosen;
        const Crossing crossing = cross(wo, eta_[wavelength]);
        if (crossing.cos_far == 0) return {};
        const float share = static_cast<float>(kWavelengths) * (1 - crossing.reflectance) / (1 - p);
        const float scale = crossing.scale(draw.transport);
        BsdfSample kept = refracted(wo, crossing, SampledSpectrum::only(wavelength, share * scale));
        kept.dispersed = true;
        return kept;
    }

    SampledSpectrum eta_;
    bool dispersive_;
};

}  // namespace sunfleck::engine
