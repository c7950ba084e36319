// SunLight: light from a disc infinitely far away, which may be darker towards its limb.
//
// Spectrum: radiance summed over the disc, W/m^2: the irradiance on a plane that faces a small
// disc. Directions are uniform within the disc. Photons start on the disc of the scene sphere,
// which is perpendicular to their direction.
#pragma once

#include "light/model.h"
#include "math/trigonometry.h"

namespace sunfleck::engine {

struct SunLight {
    static constexpr std::string_view name = "sun";
    static constexpr bool comes_from_afar = true;
    Spectrum curve;
    Vec3d direction;     // unit; direction in which the light of the disc's middle travels
    double versine = 0;  // 1 - cos of the disc's angular radius; positive
    /// Radiance over its mean, a polynomial in the cosine at which the sun's surface is seen: one
    /// in the middle, zero at the limb. Its mean over the disc is one.
    std::array<double, 6> darkening{1};

    Emission sample_emission(const EmissionDimensions& u, const SceneSphere& sphere) const;
    EmissionDimensions emission_dimensions(const LightRay& ray, const SceneSphere& sphere) const;
    double emission_pdf(const LightRay&, const SceneSphere& sphere) const;
    std::optional<DirectSample> sample_direct(const Vec3& point, const Vec2& u,
                                              const SceneSphere&) const;
    double power(const SceneSphere& sphere) const;
    EnvironmentRadiance environment_radiance(const Vec3& from, const Vec3& direction) const;

private:
    double solid_angle() const { return 2 * kPiDouble * versine; }
    /// Returns the radiance over its mean. @param radius2  squared distance from the middle, over
    /// that of the limb.
    double brightness(double radius2) const;
};

/// Returns SunLight::versine of a disc. @param radius  angular, in degrees.
inline double versine_of(double radius) {
    const double half = sin_cos_2pi(radius / 2 / 360).sin;
    return 2 * half * half;
}

/// Returns the coefficients times the number that makes SunLight::darkening of them.
std::array<double, 6> normalised_darkening(std::array<double, 6> coefficients);

}  // namespace sunfleck::engine
