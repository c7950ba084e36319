// SkyModel: radiance of a clear sky and of the sun, wavelength by wavelength.
//
// Radiance is in W/(m^2 sr nm), at eleven wavelengths; between them it is linear.
// Source: Hosek and Wilkie, An Analytic Model for Full Spectral Sky-Dome Radiance (SIGGRAPH 2012)
// and Adding a Solar-Radiance Function to the Hosek-Wilkie Skylight Model (CG&A 2013).
#pragma once

#include <array>
#include <cstddef>

namespace sunfleck::engine {

inline constexpr std::size_t kSkyWavelengths = 11;
/// Returns 320, 360, ... 720 nm.
constexpr double sky_wavelength(std::size_t i) {
    return 320 + 40 * static_cast<double>(i);
}
/// A value per wavelength.
using SkyCurve = std::array<double, kSkyWavelengths>;

struct SkyState {
    double elevation = 0;        // of the sun over the horizon, in radians, 0 to pi / 2
    double turbidity = 3;        // 1 to 10
    double ground_albedo = 0.3;  // 0 to 1
};

class SkyModel {
public:
    explicit SkyModel(const SkyState& state);

    /// Returns the radiance of the sky from a direction, without the sun's disc.
    /// @param cos_zenith  cosine of the angle to the zenith; not negative.
    /// @param cos_sun  cosine of the angle to the sun's middle.
    SkyCurve sky(double cos_zenith, double cos_sun) const;

    /// Returns the radiance of the sun's disc without darkening. @param elevation  of the point of
    /// the disc, in radians.
    SkyCurve sun(double elevation) const;

    /// Returns by what sun() is multiplied at a point of the disc: the coefficients of a polynomial
    /// in the cosine at which the sun's surface is seen there, the constant first.
    static std::array<SkyCurve, 6> limb_darkening();

private:
    double turbidity_;
    std::array<std::array<double, 9>, kSkyWavelengths> shape_{};
    SkyCurve radiance_{};
};

}  // namespace sunfleck::engine
