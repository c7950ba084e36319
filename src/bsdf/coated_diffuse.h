// CoatedDiffuse: a diffuse base under a clear coat, all reflections between them in closed form.
//
// Light enters the coat (Coat::entering, by the cosine c in the air). The base of albedo a scatters
// it diffusely, the coat returns a fraction K of that (Coat::returning) any number of times, and
// the rest leaves: f = entering(c_from) entering(c_to) a / (pi eta^2 (1 - a K)), plus the coat's
// own reflection. The result is exact for a diffuse base.
// Source: Saunderson 1942, extended by angles. pbrt-v4 estimates the same value by random walks.
#pragma once

#include "bsdf/coat_reflection.h"
#include "bsdf/lambert.h"

namespace sunfleck::engine {

/// The diffuse lobe of a coated base, without the coat's own reflection; the same on both sides.
struct CoatedBase {
    SampledSpectrum albedo;  // of the base; albedo times returning() is below one
    const Coat* coat;

    SampledSpectrum eval(const Vec3& wo, const Vec3& wi, Transport) const {
        if (!gathers(wo.z, wi.z)) return {};
        return scattered() * (entering(wo) * entering(wi) / kPi);
    }

    float pdf(const Vec3& wo, const Vec3& wi, Transport transport) const {
        return Lambert{albedo}.pdf(wo, wi, transport);
    }

    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfSampleInput& draw) const {
        auto drawn = Lambert{scattered()}.sample(wo, draw);
        if (drawn) drawn->weight *= entering(wo) * entering(drawn->wi);
        return drawn;
    }

    static constexpr Scattering scattering() { return Scattering::diffuse; }
    static bool gathers(float z_from, float z_to) { return Lambert::gathers(z_from, z_to); }
    /// Share of the light from that side that the base sends back into the air.
    SampledSpectrum diffuse_albedo(const Vec3& wo) const {
        return scattered() * (entering(wo) * coat->mean_entering());
    }
    static constexpr float reflection_probability(const Vec3&, const HeroWavelength&) { return 0; }

    /// Returns pi times the radiance towards the air, per unit of light that has entered.
    SampledSpectrum scattered() const {
        const float eta = coat->eta();
        return albedo / ((SampledSpectrum(1) - albedo * coat->returning()) * (eta * eta));
    }

private:
    float entering(const Vec3& w) const { return coat->entering(std::min(1.0F, std::abs(w.z))); }
};

struct CoatedDiffuse {
    SampledSpectrum albedo;
    const Coat* coat;

    CoatReflection top() const { return {coat}; }
    CoatedBase base() const { return {albedo, coat}; }

    SampledSpectrum eval(const Vec3& wo, const Vec3& wi, Transport transport) const {
        SampledSpectrum f = base().eval(wo, wi, transport);
        if (coat->facets()) f += top().eval(wo, wi, transport);
        return f;
    }

    float pdf(const Vec3& wo, const Vec3& wi, Transport transport) const {
        const float chance = chance_of_top(wo);
        const float below = (1 - chance) * base().pdf(wo, wi, transport);
        return coat->facets() ? below + chance * top().pdf(wo, wi, transport) : below;
    }

    /// Samples the coat's reflection or the base, selected by u.x.
    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfSampleInput& draw) const {
        if (wo.z == 0) return {};
        const float chance = chance_of_top(wo);
        const bool above = draw.u.x < chance;
        auto drawn = above ? top().sample(wo, draw) : base().sample(wo, draw);
        if (!drawn) return {};
        if (!coat->facets()) {
            drawn->weight /= above ? chance : 1 - chance;
            if (drawn->pdf) *drawn->pdf *= 1 - chance;
            return drawn;
        }
        const float density = pdf(wo, drawn->wi, draw.transport);
        if (!(density > 0)) return {};
        drawn->weight = eval(wo, drawn->wi, draw.transport) * (std::abs(drawn->wi.z) / density);
        drawn->pdf = density;
        return drawn;
    }

    /// Returns the probability with which sample() selects the coat's reflection.
    float chance_of_top(const Vec3& wo) const {
        const float above = coat->reflectance(std::min(1.0F, std::abs(wo.z)));
        return above / (above + base().diffuse_albedo(wo).mean() + 1e-6F);
    }

    static constexpr Scattering scattering() { return Scattering::coated; }
    static bool gathers(float z_from, float z_to) { return CoatedBase::gathers(z_from, z_to); }
    SampledSpectrum diffuse_albedo(const Vec3& wo) const { return base().diffuse_albedo(wo); }
    static constexpr float reflection_probability(const Vec3&, const HeroWavelength&) { return 0; }
};

}  // namespace sunfleck::engine
