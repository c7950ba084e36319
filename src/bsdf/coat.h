// A clear coat over something: how much light it reflects, lets in, and holds back from below.
//
// A plane layer of one index, with smooth or rough (GGX) boundary to the air; light fades as
// exp(-thickness / |cos|) on each way through it, as in pbrt-v4. What it lets through is measured
// once, by quadrature; below it light is taken to be spread evenly (by a diffuse base).
// Source: Stokes's relations; Saunderson, Calculation of the Color of Pigmented Plastics (JOSA
// 1942), with angles kept; Walter et al. 2007 for the rough boundary.
#pragma once

#include "bsdf/fresnel.h"
#include "bsdf/ggx.h"

#include <array>
#include <optional>

namespace sunfleck::engine {

class Coat {
public:
    /// @param eta  of the layer over the air, positive. @param facets  none: smooth.
    /// @param thickness  not negative; in units of the length over which light fades by e.
    Coat(float eta, const std::optional<Ggx>& facets, float thickness);

    float eta() const { return eta_; }
    const std::optional<Ggx>& facets() const { return facets_; }

    /// Share of the light of a direction in the air that reaches the base. By reciprocity, an even
    /// radiance L of the base shows as L * entering(cosine) / eta^2. @param cosine  in (0,1].
    float entering(float cosine) const {
        if (!facets_) return passed_smooth(cosine);
        const float place = cosine * kCells;
        const auto cell = std::min(static_cast<std::size_t>(place), std::size_t{kCells - 1});
        const float beyond = place - static_cast<float>(cell);
        return table_[cell] + (table_[cell + 1] - table_[cell]) * beyond;
    }
    /// Mean of entering() over evenly spread light.
    float mean_entering() const { return mean_entering_; }
    /// Share of the base's evenly spread light that comes back to it from the coat.
    float returning() const { return returning_; }
    /// Fresnel reflectance of the boundary from the air. @param cosine  with the (facet's) normal.
    float reflectance(float cosine) const { return dielectric_reflectance(cosine, eta_); }

    /// What one way through the layer leaves. @param cosine  within it.
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
    std::array<float, kCells + 1> table_{};  // of entering(), by cosine; rough alone
    float mean_entering_ = 0;
    float returning_ = 0;
};

}  // namespace sunfleck::engine
