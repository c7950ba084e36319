// Evaluation of the metal's lobe through the coat, and sampling of both lobes.
#include "bsdf/coated_conductor.h"

namespace sunfleck::engine {
namespace {

/// Returns facets with the slope variance of the metal plus two crossings of the coat's boundary.
Ggx widened(const std::optional<Ggx>& metal, const Coat& coat) {
    const float bend = 1 - 1 / coat.eta();
    const auto wide = [&](float inner, float outer) {
        return std::max(1e-4F, std::sqrt(inner * inner + 0.5F * bend * bend * outer * outer));
    };
    const Ggx none{0, 0};
    const Ggx& a = metal ? *metal : none;
    const Ggx& b = coat.facets() ? *coat.facets() : none;
    return {wide(a.alpha_x, b.alpha_x), wide(a.alpha_y, b.alpha_y)};
}

}  // namespace

CoatedConductor::CoatedConductor(const SampledSpectrum& eta, const SampledSpectrum& k,
                                 const std::optional<Ggx>& facets, const Coat* coat)
    : eta_(eta / coat->eta()),
      k_(k / coat->eta()),
      facets_(widened(facets, *coat)),
      coat_(coat),
      is_smooth_(!facets && !coat->facets()) {}

CoatedConductor::Inner CoatedConductor::inner(const Vec3& w) const {
    const float cosine = std::min(1.0F, std::abs(w.z));
    const float eta = coat_->eta();
    const float within = refracted_cosine(1 - cosine * cosine, eta);
    return {Vec3(w.x / eta, w.y / eta, std::copysign(within, w.z)), coat_->entering(cosine),
            coat_->reflectance(cosine), coat_->attenuated(within)};
}

SampledSpectrum CoatedConductor::smooth_reflectance(float cosine) const {
    const float eta = coat_->eta();
    const float within = refracted_cosine(1 - cosine * cosine, eta);
    if (within == 0) return SampledSpectrum(1);
    const float top = coat_->reflectance(cosine);
    const float attenuation = coat_->attenuated(within) * coat_->attenuated(within);
    const SampledSpectrum metal = conductor_reflectance(within, eta_, k_);
    return SampledSpectrum(top) + metal * ((1 - top) * (1 - top) * attenuation) /
                                      (SampledSpectrum(1) - metal * (top * attenuation));
}

SampledSpectrum CoatedConductor::metal_eval(const Vec3& wo, const Vec3& wi) const {
    const Inner a = inner(wo);
    const Inner b = inner(wi);
    const Vec3 sum = a.w + b.w;
    const float length = sum.length();
    if (!(length > 0) || a.w.z == 0 || b.w.z == 0) return {};
    const float eta = coat_->eta();
    const float shape = facets_.density(sum / length) * facets_.shadowing_over_cosines(a.w, b.w) *
                        0.25F * a.passed * b.passed / (eta * eta);
    const SampledSpectrum metal = conductor_reflectance(std::min(1.0F, 0.5F * length), eta_, k_);
    const float again = std::sqrt(a.coat * b.coat) * a.attenuation * b.attenuation;
    return metal * shape / (SampledSpectrum(1) - metal * again);
}

float CoatedConductor::metal_pdf(const Vec3& wo, const Vec3& wi) const {
    const Inner a = inner(wo);
    const Inner b = inner(wi);
    const Vec3 sum = a.w + b.w;
    const float length = sum.length();
    if (!(length > 0) || b.w.z == 0) return 0;
    const float eta = coat_->eta();
    return facets_.visible_density_over_cosine(a.w, sum / length) * 0.25F * std::abs(wi.z) /
           (eta * eta * std::abs(b.w.z));
}

SampledSpectrum CoatedConductor::eval(const Vec3& wo, const Vec3& wi, Transport transport) const {
    if (!gathers(wo.z, wi.z)) return {};
    SampledSpectrum f = metal_eval(wo, wi);
    if (coat_->facets()) f += CoatReflection{coat_}.eval(wo, wi, transport);
    return f;
}

float CoatedConductor::pdf(const Vec3& wo, const Vec3& wi, Transport transport) const {
    if (!gathers(wo.z, wi.z)) return 0;
    const float top = chance_of_top(wo);
    const float metal = (1 - top) * metal_pdf(wo, wi);
    if (!coat_->facets()) return metal;
    return metal + top * CoatReflection{coat_}.pdf(wo, wi, transport);
}

float CoatedConductor::chance_of_top(const Vec3& wo) const {
    const Inner a = inner(wo);
    const float metal = a.passed * a.passed *
                        conductor_reflectance(std::max(0.01F, std::abs(a.w.z)), eta_, k_).mean();
    return a.coat / (a.coat + metal + 1e-6F);
}

/// Samples a direction in the air by the metal's lobe; nothing if it cannot leave the coat.
std::optional<Vec3> CoatedConductor::sample_metal(const Vec3& wo,
                                                  const BsdfSampleInput& draw) const {
    const float side = std::copysign(1.0F, wo.z);
    const Vec3 w = inner(wo).w * side;
    if (!(w.z > 0)) return {};
    const Vec3 h = facets_.sample_visible(w, draw.u.y, draw.u.z);
    const Vec3 mirrored = h * (2 * w.dot(h)) - w;
    const float eta = coat_->eta();
    const float x = mirrored.x * eta;
    const float y = mirrored.y * eta;
    const float height2 = 1 - x * x - y * y;
    if (!(mirrored.z > 0) || !(height2 > 0)) return {};
    return Vec3(x, y, std::sqrt(height2)) * side;
}

std::optional<BsdfSample> CoatedConductor::sample(const Vec3& wo,
                                                  const BsdfSampleInput& draw) const {
    if (wo.z == 0) return {};
    if (is_smooth_)
        return BsdfSample{
            smooth_reflectance(std::min(1.0F, std::abs(wo.z))), Vec3(-wo.x, -wo.y, wo.z), {}};
    const float chance = chance_of_top(wo);
    std::optional<Vec3> wi;
    if (draw.u.x < chance) {
        auto top = CoatReflection{coat_}.sample(wo, draw);
        if (!top) return {};
        if (!top->pdf) top->weight /= chance;
        if (!top->pdf) return top;
        wi = top->wi;
    } else {
        wi = sample_metal(wo, draw);
    }
    if (!wi) return {};
    const float density = pdf(wo, *wi, draw.transport);
    if (!(density > 0)) return {};
    return BsdfSample{eval(wo, *wi, draw.transport) * (std::abs(wi->z) / density), *wi, density};
}

}  // namespace sunfleck::engine
