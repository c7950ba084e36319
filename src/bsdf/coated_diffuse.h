// A diffuse surface under a clear coat, with all reflections between the two, in closed form.
//
// Light enters the coat (c = cosine in the air, Coat::entering), is scattered evenly by the base of
// albedo a, comes back from the coat's underside (share K, Coat::returning) any number of times,
// and leaves:  f = entering(c_from) entering(c_to) a / (pi eta^2 (1 - a K)), plus the coat's own
// reflection. Exact for a diffuse base.
// Source: Saunderson 1942, with angles kept. pbrt-v4 finds the same value by random walks.
#pragma once

#include "bsdf/coat_reflection.h"
#include "bsdf/lambert.h"

namespace sunfleck::engine {

/// What comes back from the base; both sides alike.
struct CoatedBase {
    SampledSpectrum albedo;  // of the base, per wavelength; times returning() below one
    const Coat* coat;

    SampledSpectrum eval(const Vec3& wo, const Vec3& wi, Transport) const {
        if (!gathers(wo.z, wi.z)) return {};
        return scattered() * (entering(wo) * entering(wi) / kPi);
    }

    float pdf(const Vec3& wo, const Vec3& wi, Transport transport) const {
        return Lambert{albedo}.pdf(wo, wi, transport);
    }

    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfDraw& draw) const {
        auto drawn = Lambert{scattered()}.sample(wo, draw);
        if (drawn) drawn->weight *= entering(wo) * entering(drawn->wi);
        return drawn;
    }

    static constexpr Scattering scattering() { return Scattering::diffuse; }
    static bool gathers(float z_from, float z_to) { return Lambert::gathers(z_from, z_to); }
    /// Share of the light from that side that the base sends back into the air.
    SampledSpectrum spread_share(const Vec3& wo) const {
        return scattered() * (entering(wo) * coat->mean_entering());
    }
    static constexpr float mirror_share(const Vec3&, const HeroWavelength&) { return 0; }

    /// Of light that has entered: radiance towards the air, times pi.
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

    /// The coat's reflection or the base's light, by u.x.
    std::optional<BsdfSample> sample(const Vec3& wo, const BsdfDraw& draw) const {
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

    static constexpr Scattering scattering() { return Scattering::coated; }
    static bool gathers(float z_from, float z_to) { return CoatedBase::gathers(z_from, z_to); }
    SampledSpectrum spread_share(const Vec3& wo) const { return base().spread_share(wo); }
    static constexpr float mirror_share(const Vec3&, const HeroWavelength&) { return 0; }

private:
    float chance_of_top(const Vec3& wo) const {
        const float above = coat->reflectance(std::min(1.0F, std::abs(wo.z)));
        return above / (above + base().spread_share(wo).mean() + 1e-6F);
    }
};

}  // namespace sunfleck::engine
