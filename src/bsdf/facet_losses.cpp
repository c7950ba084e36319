// The table of what facets lose, by quadrature over the facets that a direction sees.
#include "bsdf/facet_losses.h"

#include "bsdf/fresnel.h"

#include <memory>

namespace sunfleck::engine {
namespace {

// Of the facets that a direction sees, Fibonacci's lattice: no ring of facets, as the critical
// angle cuts one out, lies along its rows.
constexpr int kFacets = 1597;
constexpr int kLatticeStep = 987;

/// Numbers of sample_visible(), close together at the edge of its disc: the long tail of GGX.
struct Number {
    float value;
    double weight;

    /// @param place  in (-1,1), evenly spread.
    static Number at(double place) {
        const double p2 = place * place;
        const double stretched = place * (15 - p2 * (10 - 3 * p2)) / 8;
        return {static_cast<float>(0.5 + 0.5 * stretched), (1 - p2) * (1 - p2) * 15 / 8};
    }
};

/// What stays in the lobes of one facet: reflected whole, and by glass.
struct Seen {
    const Ggx& facets;
    Vec3 w;
    Vec3 h;
    float cosine;

    float mirrored() const {
        const Vec3 wi = h * (2 * cosine) - w;
        return wi.z > 0 ? facets.shadowing_given_masking(w, wi) : 0;
    }

    /// @param reflected  mirrored().
    float kept(float far_over_near, float reflected) const {
        const float far = refracted_cosine(1 - cosine * cosine, far_over_near);
        if (far == 0) return reflected;
        const float share = dielectric_reflectance(cosine, far, far_over_near);
        const Vec3 wi = h * (cosine / far_over_near - far) - w / far_over_near;
        const float passed = wi.z < 0 ? facets.shadowing_given_masking(w, wi) : 0;
        return share * reflected + (1 - share) * passed;
    }
};

}  // namespace

const FacetLosses& FacetLosses::table() {
    static const std::unique_ptr<const FacetLosses> made(new FacetLosses);
    return *made;
}

FacetLosses::FacetLosses() {
    for (std::size_t width = 0; width <= kWidths; ++width)
        for (std::size_t cosine = 0; cosine <= kCosines; ++cosine) measure(width, cosine);
    for (Slice& slice : glass_) take_means(slice);
    take_means(mirror_);
}

/// Of no width the row is the limit: by cosine / alpha, losses along the surface stay.
float FacetLosses::width_at(std::size_t node) {
    return std::max(1e-3F, static_cast<float>(node) / kWidths);
}

/// The inverse of place_of_cosine().
float FacetLosses::cosine_at(std::size_t node, float alpha) {
    const float t = static_cast<float>(node) / kCosines;
    return std::max(1e-6F, alpha * t / (1 + alpha - t));
}

float FacetLosses::index_at(std::size_t node) {
    const float root = (2 * static_cast<float>(node) / kIndices - 1) * kRoot;
    const float amplitude = std::abs(root) * root;
    return (1 + amplitude) / (1 - amplitude);
}

void FacetLosses::measure(std::size_t width, std::size_t cosine) {
    const float alpha = width_at(width);
    const Ggx facets{alpha, alpha};
    const float z = std::min(1.0F, cosine_at(cosine, alpha));
    const Vec3 w(std::sqrt(1 - z * z), 0, z);
    std::array<double, kIndices + 1> glass{};
    double mirror = 0;
    double all = 0;
    for (int i = 0; i < kFacets; ++i) {
        const Number u = Number::at((2 * i + 1.0) / kFacets - 1);
        const Number v = Number::at((2 * (i * kLatticeStep % kFacets) + 1.0) / kFacets - 1);
        const double weight = u.weight * v.weight;
        all += weight;
        const Vec3 h = facets.sample_visible(w, u.value, v.value);
        const Seen seen{facets, w, h, std::min(1.0F, w.dot(h))};
        if (!(seen.cosine > 0)) continue;
        const float reflected = seen.mirrored();
        mirror += weight * static_cast<double>(reflected);
        for (std::size_t k = 0; k <= kIndices; ++k)
            glass.at(k) += weight * static_cast<double>(seen.kept(index_at(k), reflected));
    }
    const auto lost = [all](double kept) {
        return std::max(0.0F, static_cast<float>(1 - kept / all));
    };
    mirror_.lost.at(width).at(cosine) = lost(mirror);
    for (std::size_t k = 0; k <= kIndices; ++k)
        glass_.at(k).lost.at(width).at(cosine) = lost(glass.at(k));
}

/// The squared cosine of evenly spread light is uniform.
void FacetLosses::take_means(Slice& slice) const {
    constexpr int kAngles = 512;
    for (std::size_t width = 0; width <= kWidths; ++width) {
        double sum = 0;
        for (int i = 0; i < kAngles; ++i)
            sum +=
                static_cast<double>(looked_up(slice, static_cast<float>(width) / kWidths,
                                              std::sqrt((static_cast<float>(i) + 0.5F) / kAngles)));
        slice.mean.at(width) = static_cast<float>(sum / kAngles);
    }
}

}  // namespace sunfleck::engine
