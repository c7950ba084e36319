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

namespace sunfleck {

/// What comes back from the base; both sides alike.
struct CoatedBase {
    Spectrum albedo;  // of the base, per lane; times returning() below one
    const Coat* coat;

    Spectrum eval(const Vec3& w_from, const Vec3& w_to, Transport) const {
        if (!gathers(w_from.z, w_to.z)) return {};
        return scattered() * (entering(w_from) * entering(w_to) / kPi);
    }

    float pdf(const Vec3& w_from, const Vec3& w_to, Transport transport) const {
        return Lambert{albedo}.pdf(w_from, w_to, transport);
    }

    std::optional<BsdfSample> sample(const Vec3& w_from, const BsdfDraw& draw) const {
        auto drawn = Lambert{scattered()}.sample(w_from, draw);
        if (drawn) drawn->weight *= entering(w_from) * entering(drawn->w_to);
        return drawn;
    }

    static constexpr Scattering scattering() { return Scattering::diffuse; }
    static bool gathers(float z_from, float z_to) { return Lambert::gathers(z_from, z_to); }

    /// Of light that has entered: radiance towards the air, times pi.
    Spectrum scattered() const {
        const float eta = coat->eta();
        return albedo / ((Spectrum(1) - albedo * coat->returning()) * (eta * eta));
    }
    /// Share of the light from that side that the base sends back into the air.
    Spectrum reflectance(const Vec3& w_from) const {
        return scattered() * (entering(w_from) * coat->mean_entering());
    }

private:
    float entering(const Vec3& w) const { return coat->entering(std::min(1.0F, std::abs(w.z))); }
};

struct CoatedDiffuse {
    Spectrum albedo;
    const Coat* coat;

    CoatReflection top() const { return {coat}; }
    CoatedBase base() const { return {albedo, coat}; }

    Spectrum eval(const Vec3& w_from, const Vec3& w_to, Transport transport) const {
        Spectrum f = base().eval(w_from, w_to, transport);
        if (coat->facets()) f += top().eval(w_from, w_to, transport);
        return f;
    }

    float pdf(const Vec3& w_from, const Vec3& w_to, Transport transport) const {
        const float chance = chance_of_top(w_from);
        const float below = (1 - chance) * base().pdf(w_from, w_to, transport);
        return coat->facets() ? below + chance * top().pdf(w_from, w_to, transport) : below;
    }

    /// The coat's reflection or the base's light, by u.x.
    std::optional<BsdfSample> sample(const Vec3& w_from, const BsdfDraw& draw) const {
        if (w_from.z == 0) return {};
        const float chance = chance_of_top(w_from);
        const bool above = draw.u.x < chance;
        auto drawn = above ? top().sample(w_from, draw) : base().sample(w_from, draw);
        if (!drawn) return {};
        if (!coat->facets()) {
            drawn->weight /= above ? chance : 1 - chance;
            if (drawn->pdf) *drawn->pdf *= 1 - chance;
            return drawn;
        }
        const float density = pdf(w_from, drawn->w_to, draw.transport);
        if (!(density > 0)) return {};
        drawn->weight =
            eval(w_from, drawn->w_to, draw.transport) * (std::abs(drawn->w_to.z) / density);
        drawn->pdf = density;
        return drawn;
    }

    static constexpr Scattering scattering() { return Scattering::coated; }
    static bool gathers(float z_from, float z_to) { return CoatedBase::gathers(z_from, z_to); }

private:
    float chance_of_top(const Vec3& w_from) const {
        const float above = coat->reflectance(std::min(1.0F, std::abs(w_from.z)));
        return above / (above + base().reflectance(w_from).mean() + 1e-6F);
    }
};

}  // namespace sunfleck
