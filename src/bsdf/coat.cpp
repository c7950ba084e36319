// What a coat lets through and sends back, by quadrature.
#include "bsdf/coat.h"

namespace sunfleck::engine {
namespace {

constexpr int kFacets = 24;  // each way, of those that a direction sees

/// Mean of f(cosine) over evenly spread light: the squared cosine is uniform.
template <class F>
float mean_over_angles(int count, const F& f) {
    double sum = 0;
    for (int i = 0; i < count; ++i)
        sum += static_cast<double>(
            f(std::sqrt((static_cast<float>(i) + 0.5F) / static_cast<float>(count))));
    return static_cast<float>(sum / count);
}

/// Mean of f(normal) over the facets that a direction sees.
template <class F>
float mean_over_facets(const Ggx& facets, const Vec3& w, const F& f) {
    double sum = 0;
    for (int i = 0; i < kFacets; ++i)
        for (int j = 0; j < kFacets; ++j)
            sum += static_cast<double>(
                f(facets.sample_visible(w, (static_cast<float>(i) + 0.5F) / kFacets,
                                        (static_cast<float>(j) + 0.5F) / kFacets)));
    return static_cast<float>(sum / (kFacets * kFacets));
}

/// A direction of that cosine, between the axes of facets that are wider one way.
Vec3 between_axes(float cosine) {
    const float across = std::sqrt(std::max(0.0F, 1 - cosine * cosine) / 2);
    return {across, across, cosine};
}

}  // namespace

Coat::Coat(float eta, const std::optional<Ggx>& facets, float thickness)
    : eta_(eta), facets_(facets), thickness_(thickness) {
    if (facets_)
        for (int i = 0; i <= kCells; ++i)
            table_.at(static_cast<std::size_t>(i)) =
                passed_rough(std::max(1e-3F, static_cast<float>(i) / kCells));
    const int angles = facets_ ? 64 : 2048;  // a smooth boundary has an edge: total reflection
    mean_entering_ = mean_over_angles(angles, [&](float c) { return entering(c); });
    returning_ = mean_over_angles(
        angles, [&](float c) { return facets_ ? returned_rough(c) : returned_smooth(c); });
}

float Coat::passed_smooth(float cosine) const {
    const float inside = refracted_cosine(1 - cosine * cosine, eta_);
    if (inside == 0) return 0;
    return (1 - dielectric_reflectance(cosine, inside, eta_)) * attenuated(inside);
}

float Coat::passed_rough(float cosine) const {
    const Vec3 w = between_axes(cosine);
    return mean_over_facets(*facets_, w, [&](const Vec3& h) {
        const float c = std::min(1.0F, w.dot(h));
        if (!(c > 0)) return 0.0F;
        const float far = refracted_cosine(1 - c * c, eta_);
        if (far == 0) return 0.0F;
        const Vec3 wi = (h * (c / eta_ - far) - w / eta_).normalized();
        if (!(wi.z < 0)) return 0.0F;
        return (1 - dielectric_reflectance(c, far, eta_)) *
               facets_->shadowing_given_masking(w, wi) * attenuated(-wi.z);
    });
}

float Coat::returned_smooth(float cosine) const {
    const float way = attenuated(cosine);
    return way * way * dielectric_reflectance(cosine, 1 / eta_);
}

float Coat::returned_rough(float cosine) const {
    const Vec3 w = between_axes(cosine);
    return attenuated(cosine) * mean_over_facets(*facets_, w, [&](const Vec3& h) {
               const float c = std::min(1.0F, w.dot(h));
               const Vec3 wi = h * (2 * c) - w;
               if (!(c > 0) || !(wi.z > 0)) return 0.0F;
               return dielectric_reflectance(c, 1 / eta_) *
                      facets_->shadowing_given_masking(w, wi) * attenuated(wi.z);
           });
}

}  // namespace sunfleck::engine
