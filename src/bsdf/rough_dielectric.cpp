// Rough glass: both lobes for one index, and how wavelengths share them.
#include "bsdf/rough_dielectric.h"

#include "bsdf/fresnel.h"
#include "bsdf/lambert.h"

namespace sunfleck::engine {

namespace {

/// The facet that refracts one direction into the other. It is computed from the two sides, not
/// from wo and wi, so that an exchange of these changes no bit.
struct RefractingFacet {
    Vec3 normal;  // unit vector
    float cos_out =
        0;             // cosine of the outer direction with the normal; 0 if there is no such facet
    float cos_in = 0;  // cosine of the inner direction, positive
    float length2 = 0;  // (cos_out - eta cos_in)^2: the change of solid angle
};

RefractingFacet refracting_facet(const Vec3& a, const Vec3& b, float eta) {
    const Vec3& outer = a.z > 0 ? a : b;
    const Vec3& inner = a.z > 0 ? b : a;
    const Vec3 sum = outer + inner * eta;  // along the facet's normal by Snell's law
    const float length2 = sum.length2();
    if (!(length2 > 0)) return {};
    const Vec3 normal = sum * (std::copysign(1.0F, sum.z) / std::sqrt(length2));
    const float cos_out = outer.dot(normal);
    const float cos_in = -inner.dot(normal);
    if (!(cos_out > 0 && cos_in > 0)) return {};  // the facet is seen from behind
    return {normal, std::min(1.0F, cos_out), std::min(1.0F, cos_in), length2};
}

/// Rough glass of one index between two given directions.
struct GlassAtWavelength {
    const Ggx& facets;
    float eta;  // index inside over outside
    const FacetLosses* losses;

    /// Returns the factor of f that both transports share. Times the squared index of the side into
    /// which light leaves, it is Walter's eq. 21.
    float transmitted(const Vec3& a, const Vec3& b) const {
        const RefractingFacet facet = refracting_facet(a, b, eta);
        if (facet.cos_out == 0) return with_compensation(0, a, b);
        const float passed = 1 - dielectric_reflectance(facet.cos_out, facet.cos_in, eta);
        return with_compensation(passed * facets.density(facet.normal) *
                                     facets.shadowing_over_cosines(a, b) * facet.cos_out *
                                     facet.cos_in / facet.length2,
                                 a, b);
    }

    float transmitted_pdf(const Vec3& wo, const Vec3& wi) const {
        const RefractingFacet facet = refracting_facet(wo, wi, eta);
        if (facet.cos_out == 0) return 0;
        const float passed = 1 - dielectric_reflectance(facet.cos_out, facet.cos_in, eta);
        const float index_to = wi.z > 0 ? 1 : eta;
        return passed * facets.visible_density_over_cosine(wo, facet.normal) * index_to * index_to *
               facet.cos_out * facet.cos_in / facet.length2;
    }

    /// @param cosine  between either direction and the facet.
    float reflected_share(float cosine, float z) const {
        return dielectric_reflectance(std::min(1.0F, cosine), z > 0 ? eta : 1 / eta);
    }

    GlassCompensation compensation() const { return {*losses, facets, eta}; }
    /// @param f  of the facets, without the squared index of transmitted().
    float with_compensation(float f, const Vec3& a, const Vec3& b) const {
        return losses == nullptr ? f : f + compensation().eval(a.z, b.z);
    }
    /// @param density  with which sample_facets() chooses wi.
    float with_compensation_pdf(float density, const Vec3& wo, const Vec3& wi) const {
        if (losses == nullptr) return density;
        const float chance = compensation().lost(wo.z);
        return (1 - chance) * density + chance * compensation().pdf(wo.z, wi.z);
    }

    std::optional<BsdfSample> sample_facets(const Vec3& wo, const BsdfSampleInput& draw) const;
    std::optional<BsdfSample> sample_compensation(const Vec3& wo,
                                                  const BsdfSampleInput& draw) const;
};

/// Samples the compensation lobes with the probability of all facets' losses, else the facets.
/// @return direction and eta only.
std::optional<BsdfSample> GlassAtWavelength::sample_compensation(
    const Vec3& wo, const BsdfSampleInput& draw) const {
    const float chance = compensation().lost(wo.z);
    BsdfSampleInput rest = draw;
    if (!(draw.u.x < chance)) {
        rest.u.x = (draw.u.x - chance) / (1 - chance);
        return sample_facets(wo, rest);
    }
    auto drawn = Lambert{SampledSpectrum(1)}.sample(wo, draw);
    if (drawn && draw.u.x < chance * compensation().passing(wo.z)) {
        drawn->wi.z = -drawn->wi.z;
        drawn->eta = wo.z > 0 ? eta : 1 / eta;
    }
    return drawn;
}

std::optional<BsdfSample> GlassAtWavelength::sample_facets(const Vec3& wo,
                                                           const BsdfSampleInput& draw) const {
    // Rotate the frame so that wo is above; GGX is symmetric under that rotation.
    const float side = std::copysign(1.0F, wo.z);
    const Vec3 w = wo * side;
    const Vec3 h = facets.sample_visible(w, draw.u.y, draw.u.z);
    const float cosine = std::min(1.0F, w.dot(h));
    if (!(cosine > 0)) return {};
    const float far_over_near = wo.z > 0 ? eta : 1 / eta;
    const float cos_far = refracted_cosine(1 - cosine * cosine, far_over_near);
    const float share = dielectric_reflectance(cosine, cos_far, far_over_near);
    const float seen = facets.visible_density_over_cosine(w, h);

    if (draw.u.x < share || cos_far == 0) {
        const Vec3 wi = h * (2 * cosine) - w;
        if (!(wi.z > 0)) return {};
        return BsdfSample{SampledSpectrum(facets.shadowing_given_masking(w, wi)), wi * side,
                          share * seen * 0.25F};
    }
    const Vec3 wi = (h * (cosine / far_over_near - cos_far) - w / far_over_near).normalized();
    if (!(wi.z < 0)) return {};
    const float eta2 = far_over_near * far_over_near;
    const float length = cosine - far_over_near * cos_far;
    const float pdf = (1 - share) * seen * cosine * cos_far * eta2 / (length * length);
    const float scale = draw.transport == Transport::radiance ? 1 / eta2 : 1;
    return BsdfSample{SampledSpectrum(scale * facets.shadowing_given_masking(w, wi)), wi * side,
                      pdf, far_over_near};
}

}  // namespace

SampledSpectrum RoughDielectric::eval(const Vec3& wo, const Vec3& wi, Transport transport) const {
    if (!gathers(wo.z, wi.z)) return {};
    const auto glass = [&](std::size_t i) { return GlassAtWavelength{facets_, eta_[i], losses_}; };
    const std::size_t different = dispersive_ ? kWavelengths : 1;
    SampledSpectrum f;
    if (wo.z * wi.z > 0) {
        const Vec3 sum = wo + wi;
        const float length = sum.length();
        if (!(length > 0)) return f;
        const float shape =
            facets_.density(sum / length) * facets_.shadowing_over_cosines(wo, wi) * 0.25F;
        for (std::size_t i = 0; i < kWavelengths; ++i)
            f[i] = shape * glass(i).reflected_share(0.5F * length, wo.z);
        if (losses_ == nullptr) return f;
        for (std::size_t i = 0; i < kWavelengths; ++i)
            f[i] = i < different ? glass(i).with_compensation(f[i], wo, wi) : f[0];
        return f;
    }
    // Light leaves into the side of wo in radiance transport, into that of wi in flux transport.
    const bool goes_inside = (transport == Transport::radiance ? wo.z : wi.z) < 0;
    for (std::size_t i = 0; i < different; ++i) f[i] = glass(i).transmitted(wo, wi);
    if (!dispersive_) f = SampledSpectrum(f[0]);
    return goes_inside ? f * eta_ * eta_ : f;
}

float RoughDielectric::pdf(const Vec3& wo, const Vec3& wi, Transport) const {
    if (!gathers(wo.z, wi.z)) return 0;
    const Vec3 sum = wo + wi;
    const float length = sum.length();
    const bool reflected = wo.z * wi.z > 0;
    if (reflected && !(length > 0)) return 0;
    const float seen =
        reflected ? facets_.visible_density_over_cosine(wo, sum / length) * 0.25F : 0;

    const std::size_t different = dispersive_ ? kWavelengths : 1;
    float total = 0;
    for (std::size_t i = 0; i < different; ++i) {
        const GlassAtWavelength glass{facets_, eta_[i], losses_};
        total += glass.with_compensation_pdf(reflected
                                                 ? seen * glass.reflected_share(0.5F * length, wo.z)
                                                 : glass.transmitted_pdf(wo, wi),
                                             wo, wi);
    }
    return total / static_cast<float>(different);
}

std::optional<BsdfSample> RoughDielectric::sample(const Vec3& wo,
                                                  const BsdfSampleInput& draw) const {
    if (wo.z == 0) return {};
    const std::size_t chosen = draw.hero.chosen;
    const GlassAtWavelength glass{facets_, eta_[chosen], losses_};
    auto drawn =
        losses_ == nullptr ? glass.sample_facets(wo, draw) : glass.sample_compensation(wo, draw);
    if (drawn && losses_ != nullptr) {
        const RoughDielectric alone = at_wavelength(chosen);
        drawn->pdf = alone.pdf(wo, drawn->wi, draw.transport);
        if (!(*drawn->pdf > 0)) return {};
        drawn->weight =
            alone.eval(wo, drawn->wi, draw.transport) * (std::abs(drawn->wi.z) / *drawn->pdf);
    }
    if (drawn && dispersive_ && !draw.hero.single) {
        drawn->weight =
            SampledSpectrum::only(chosen, drawn->weight[chosen] * static_cast<float>(kWavelengths));
        drawn->dispersed = true;
    }
    return drawn;
}

}  // namespace sunfleck::engine
