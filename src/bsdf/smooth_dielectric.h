// A perfectly smooth boundary between two clear media: reflects and refracts, by Fresnel's shares.
//
// In:  eta per lane, index inside (side -z) over outside (side +z). Out: two delta lobes.
// Source: Fresnel's and Snell's laws; radiance scales by the squared ratio of indices at a
// refraction (Veach 1997, section 5.2). Dispersion: docs/method.md, one lane kept.
#pragma once

#include "bsdf/fresnel.h"
#include "bsdf/model.h"

namespace sunfleck {

class SmoothDielectric {
public:
    /// @param eta  positive in all lanes; 1 lets light pass straight.
    explicit SmoothDielectric(const Spectrum& eta)
        : eta_(eta), dispersive_(eta.min() != eta.max()) {}

    static Spectrum eval(const Vec3&, const Vec3&, Transport) { return {}; }
    static float pdf(const Vec3&, const Vec3&, Transport) { return 0; }

    /// Reflects when u.x lies below the reflectance. Where lanes differ and none has been singled
    /// out, reflection keeps all of them and refraction keeps draw.lanes.chosen alone.
    std::optional<BsdfSample> sample(const Vec3& w_from, const BsdfDraw& draw) const {
        if (w_from.z == 0) return {};
        if (dispersive_ && !draw.lanes.single) return sample_lanes(w_from, draw);
        const Crossing crossing = cross(w_from, eta_[draw.lanes.chosen]);
        if (draw.u.x < crossing.reflectance || crossing.cos_far == 0)
            return BsdfSample{Spectrum(1), mirrored(w_from), {}};
        return refracted(w_from, crossing, Spectrum(crossing.scale(draw.transport)));
    }

    /// The probability with which sample() reflects.
    float mirror_share(const Vec3& w_from, const LaneChoice& lanes) const {
        if (w_from.z == 0) return 0;
        if (dispersive_ && !lanes.single) return reflectances(w_from).mean();
        const Crossing crossing = cross(w_from, eta_[lanes.chosen]);
        return crossing.cos_far == 0 ? 1 : crossing.reflectance;
    }

    static constexpr Scattering scattering() { return Scattering::specular; }
    static constexpr bool gathers(float, float) { return false; }

    const Spectrum& eta() const { return eta_; }
    bool is_dispersive() const { return dispersive_; }
    SmoothDielectric for_lane(std::size_t lane) const {
        return SmoothDielectric(Spectrum(eta_[lane]));
    }

private:
    /// One lane's light at the boundary.
    struct Crossing {
        float eta;  // far side over near side
        float cos_far;
        float reflectance;

        float scale(Transport t) const { return t == Transport::radiance ? 1 / (eta * eta) : 1; }
    };

    static Crossing cross(const Vec3& w_from, float inside) {
        const float eta = w_from.z > 0 ? inside : 1 / inside;
        const float sin2 = w_from.x * w_from.x + w_from.y * w_from.y;
        const float cos_far = refracted_cosine(sin2, eta);
        return {eta, cos_far, dielectric_reflectance(std::abs(w_from.z), cos_far, eta)};
    }

    static Vec3 mirrored(const Vec3& w) { return {-w.x, -w.y, w.z}; }

    static BsdfSample refracted(const Vec3& w, const Crossing& c, const Spectrum& weight) {
        const Vec3 w_to(-w.x / c.eta, -w.y / c.eta, std::copysign(c.cos_far, -w.z));
        return {weight, w_to, {}, c.eta};
    }

    Spectrum reflectances(const Vec3& w_from) const {
        Spectrum reflectance;
        for (std::size_t i = 0; i < kLanes; ++i)
            reflectance[i] = cross(w_from, eta_[i]).reflectance;
        return reflectance;
    }

    /// Reflection with the lanes' mean probability p, weights F / p <= kLanes. Refraction keeps one
    /// lane c, uniform over lanes, weight kLanes (1 - F_c) / (1 - p): the mean over c and u.x is
    /// 1 - F in every lane. Under total reflection of lane c that weight is zero: nothing.
    std::optional<BsdfSample> sample_lanes(const Vec3& w_from, const BsdfDraw& draw) const {
        const Spectrum reflectance = reflectances(w_from);
        const float p = reflectance.mean();
        if (draw.u.x < p || p >= 1) return BsdfSample{reflectance / p, mirrored(w_from), {}};

        const std::size_t lane = draw.lanes.chosen;
        const Crossing crossing = cross(w_from, eta_[lane]);
        if (crossing.cos_far == 0) return {};
        const float share = static_cast<float>(kLanes) * (1 - crossing.reflectance) / (1 - p);
        const float scale = crossing.scale(draw.transport);
        BsdfSample kept = refracted(w_from, crossing, Spectrum::only(lane, share * scale));
        kept.dispersed = true;
        return kept;
    }

    Spectrum eta_;
    bool dispersive_;
};

}  // namespace sunfleck
