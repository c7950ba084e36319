// Glow: light that a medium emits by itself, as fire does.
//
// A medium of absorption a and density rho emits the radiance a rho E per unit of length (pbrt-v4):
// where it is thick and does not scatter, it has the radiance E. E may vary in space, by a factor
// and by a temperature. Equations: docs/method/glow.md.
#pragma once

#include "math/spectrum.h"
#include "medium/density.h"

#include <memory>
#include <optional>

namespace sunfleck::engine {

/// Temperatures: (grid - zero) * kelvin_per_unit. Up to 100 K nothing glows (pbrt-v4).
struct Heat {
    std::shared_ptr<const Density> grid;
    float zero = 0;
    float kelvin_per_unit = 1;

    float kelvin_at(const Vec3& point) const {
        return (density_at(*grid, point) - zero) * kelvin_per_unit;
    }
};

struct Glow {
    Spectrum radiance;                        // E; with heat, a factor of the black body's radiance
    std::shared_ptr<const Density> factor{};  // of E; null: one everywhere
    std::optional<Heat> heat{};
    /// Where a medium of varying E glows: about in proportion to rho E, and more than zero where
    /// the density is (medium/glow_power.h). Null where E does not vary.
    std::shared_ptr<const DensityGrid> power{};

    bool varies() const { return factor || heat; }
    /// Returns the factor of E at a point, without the black body.
    float factor_at(const Vec3& point) const { return factor ? density_at(*factor, point) : 1; }
    /// Returns the black body of a point, of radiance one at its brightest wavelength; dark up to
    /// 100 K. There must be heat.
    BlackbodySpectrum black_body_at(const Vec3& point) const {
        constexpr float kLeastKelvin = 100;
        const float kelvin = heat->kelvin_at(point);
        return {kelvin > kLeastKelvin ? kelvin : 0};
    }
};

}  // namespace sunfleck::engine
