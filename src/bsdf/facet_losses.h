// Light that one meeting with rough (GGX) facets loses: it goes on to a second facet, which the
// lobes do not follow. And how it is given back, as wide lobes.
//
// In:  facets and a direction. Out: the lost share, from a table made by quadrature.
// Source: Kulla and Conty, Revisiting Physically Based Shading at Imageworks (SIGGRAPH 2017
// course): with L(w) = 1 - E(w) lost and A its integral over cosines, the lobe L(a) L(b) / A gives
// back all, and is reciprocal.
//
// The table knows facets of one width. Two widths count as the root of their mean square, in every
// azimuth: of metal right to 3% at 30 degrees above the surface and more, but not where it is seen
// flatly (docs/develop/decisions.md).
#pragma once

#include "bsdf/ggx.h"

#include <array>
#include <cstddef>

namespace sunfleck::engine {

class FacetLosses {
public:
    /// Made at the first call. Any number of threads.
    static const FacetLosses& table();

    /// Share in [0,1] that facets which reflect everything lose. @param cosine  with the normal,
    /// not negative.
    float of_mirror(const Ggx& facets, float cosine) const {
        return looked_up(mirror_, mean_width(facets), cosine);
    }
    /// Its mean over evenly spread light.
    float mean_of_mirror(const Ggx& facets) const { return mean(mirror_, mean_width(facets)); }

    /// Share in [0,1] that facets of glass lose, of what they reflect and refract together.
    /// @param far_over_near  index of the other side over that of the side of the direction.
    float of_glass(const Ggx& facets, float cosine, float far_over_near) const {
        const float alpha = mean_width(facets);
        const Place at = place_of_index(far_over_near);
        return at.between(looked_up(glass_[at.cell], alpha, cosine),
                          looked_up(glass_[at.cell + 1], alpha, cosine));
    }
    /// Its mean over evenly spread light.
    float mean_of_glass(const Ggx& facets, float far_over_near) const {
        const float alpha = mean_width(facets);
        const Place at = place_of_index(far_over_near);
        return at.between(mean(glass_[at.cell], alpha), mean(glass_[at.cell + 1], alpha));
    }

private:
    static constexpr std::size_t kWidths = 24;   // cells up to an alpha of one
    static constexpr std::size_t kCosines = 32;  // cells
    static constexpr std::size_t kIndices = 28;  // cells, an even number
    static constexpr float kRoot = 0.78F;        // of the greatest Fresnel amplitude: index 4.1

    /// A cell of a table, and how far beyond its start.
    struct Place {
        std::size_t cell;
        float beyond;
        float between(float low, float high) const { return low + (high - low) * beyond; }
    };
    struct Slice {
        std::array<std::array<float, kCosines + 1>, kWidths + 1> lost;
        std::array<float, kWidths + 1> mean;
    };

    FacetLosses();
    void measure(std::size_t width, std::size_t cosine);
    void take_means(Slice& slice) const;

    static float width_at(std::size_t node);
    static float cosine_at(std::size_t node, float alpha);
    static float index_at(std::size_t node);

    /// @param place  in cells. Held within the table.
    static Place place_in(float place, std::size_t cells) {
        const float held = std::clamp(place, 0.0F, static_cast<float>(cells));
        const std::size_t cell = std::min(static_cast<std::size_t>(held), cells - 1);
        return {cell, held - static_cast<float>(cell)};
    }
    /// Nodes are even in the square root of the amplitude that is reflected at a right angle: the
    /// critical angle is, too.
    static Place place_of_index(float far_over_near) {
        const float amplitude = (far_over_near - 1) / (far_over_near + 1);
        const float root = std::copysign(std::sqrt(std::abs(amplitude)), amplitude);
        return place_in((root / kRoot + 1) * 0.5F * kIndices, kIndices);
    }
    static Place place_of_width(float alpha) { return place_in(alpha * kWidths, kWidths); }
    /// Close together below alpha, where losses change.
    static float place_of_cosine(float cosine, float alpha) {
        return cosine * (1 + alpha) / (cosine + alpha) * kCosines;
    }

    static float mean_width(const Ggx& facets) {
        return std::sqrt(0.5F *
                         (facets.alpha_x * facets.alpha_x + facets.alpha_y * facets.alpha_y));
    }

    static float looked_up(const Slice& slice, float alpha, float cosine) {
        const Place width = place_of_width(alpha);
        const Place at = place_in(place_of_cosine(cosine, alpha), kCosines);
        const auto along = [&](const std::array<float, kCosines + 1>& row) {
            return at.between(row[at.cell], row[at.cell + 1]);
        };
        return width.between(along(slice.lost[width.cell]), along(slice.lost[width.cell + 1]));
    }
    static float mean(const Slice& slice, float alpha) {
        const Place width = place_of_width(alpha);
        return width.between(slice.mean[width.cell], slice.mean[width.cell + 1]);
    }

    std::array<Slice, kIndices + 1> glass_;
    Slice mirror_;
};

}  // namespace sunfleck::engine
