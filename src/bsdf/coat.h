// Coat: the clear layer of a coated material; what it reflects, transmits, and returns from below.
//
// The coat is a plane layer of one index, with a smooth or rough (GGX) boundary to the air. It
// attenuates light by exp(-thickness / |cos|) on each way, as in pbrt-v4. Its transmission is
// computed once, by quadrature. Light below it is assumed to be diffuse (from a diffuse base).
// Source: Stokes's relations; Saunderson, Calculation of the Color of Pigmented Plastics (JOSA
// 1942), extended by angles; Walter et al. 2007 for the rough boundary.
#pragma once

#include "bsdf/fresnel.h"
#include "bsdf/ggx.h"

#include <array>
#include <optional>

namespace sunfleck::engine {

class Coat {
public:
    /// @param eta  index of the layer over that of the air, positive.
    /// @param facets  of a rough boundary; none for a smooth one.
    /// @param thickness  optical depth, not negative.
    Coat(float eta, const std::optional<Ggx>& facets, float thickness);

    float eta() const { return eta_; }
    const std::optional<Ggx>& facets() const { return facets_; }
    float thickness() const { return thickness_; }

    /// Returns the fraction of light from a direction in the air that reaches the base. By
    /// reciprocity, a diffuse radiance L of the base is seen as L * entering(cosine) / eta^2.
    /// @param cosine  in (0,1].
    float entering(float cosine) const {
        if (!facets_) return passed_smooth(cosine);
        const float place = cosine * kCells;
        const auto cell = std::min(static_cast<std::size_t>(place), std::size_t{kCells - 1});
        const float beyond = place - static_cast<float>(cell);
        return table_[cell] + (table_[cell + 1] - table_[cell]) * beyond;
    }
    /// Returns the mean of entering() over diffuse light.
    float mean_entering() const { return mean_entering_; }
    /// Returns the fraction of the base's diffuse light that the coat reflects back to it.
    float returning() const { return returning_; }
    /// Returns the Fresnel reflectance of the boundary from the air. @param cosine  with the
    /// (facet's) normal.
    float reflectance(float cosine) const { return dielectric_reflectance(cosine, eta_); }

    /// Returns the transmittance of one way through the layer. @param cosine  within the layer.
    float attenuated(float cosine) const { return std::exp(-thickness_ / std::max(cosine, 1e-6F)); }

private:
    static constexpr int kCells = 32;

    float passed_smooth(float cosine) const;
    float passed_rough(float cosine) const;
    float returned_smooth(float cosine) const;
    float returned_rough(float cosine) const;

    float eta_;
    std::optional<Ggx> facets_;
    float thickness_;
    std::array<float, kCells + 1> table_{};  // entering() by cosine; used by rough coats alone
    float mean_entering_ = 0;
    float returning_ = 0;
};

}  // namespace sunfleck::engine
