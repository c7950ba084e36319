// Spectrum: a function of the wavelength as a scene gives it, evaluated once per pass.
//
// The alternatives are a closed set of small values; tables are shared, not copied.
#pragma once

#include "math/sampled_spectrum.h"
#include "math/vector.h"
#include "math/wavelengths.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace sunfleck::engine {

struct ConstantSpectrum {
    float value = 0;
};

/// Piecewise linear between the points, zero outside (pbrt-v4). Points are sorted by wavelength.
struct TabulatedSpectrum {
    struct Point {
        float nm = 0;
        float value = 0;
    };
    std::shared_ptr<const std::vector<Point>> points;
};

/// Planck's law at `kelvin`, normalised to a maximum of one (pbrt-v4).
struct BlackbodySpectrum {
    float kelvin = 6500;
};

/// scale * sigmoid(c0 x^2 + c1 x + c2), x in nm (Jakob and Hanika 2019). With `times_d65` it is
/// multiplied by the illuminant D65 of luminance one.
struct SigmoidSpectrum {
    std::array<float, 3> coefficients{};
    float scale = 1;
    bool times_d65 = false;
};

class Spectrum {
public:
    using Kind =
        std::variant<ConstantSpectrum, TabulatedSpectrum, BlackbodySpectrum, SigmoidSpectrum>;

    Spectrum() = default;
    explicit Spectrum(Kind kind, float factor = 1) : kind_(std::move(kind)), factor_(factor) {}
    static Spectrum constant(float value) { return Spectrum(ConstantSpectrum{value}); }
    /// Makes a piecewise linear spectrum.
    /// @throws Error  if there is no point, or wavelengths do not increase. A caller that knows the
    /// location in a file checks first.
    static Spectrum table(std::vector<TabulatedSpectrum::Point> points);
    /// Makes a reflectance: the smooth spectrum in [0,1] that has the colour rgb under D65. A grey
    /// is a ConstantSpectrum, exactly. Another colour takes a fit of about 0.1 ms and is exact to
    /// 2e-5.
    /// @param rgb  linear sRGB, clamped to [0,1].
    static Spectrum rgb_albedo(const Vec3& rgb);
    /// Makes a non-negative quantity without illuminant (eta, k): scale * smooth spectrum.
    static Spectrum rgb_unbounded(const Vec3& rgb);
    /// Makes an emission: rgb_unbounded() times D65 of luminance one, so that a pixel that sees it
    /// shows rgb.
    static Spectrum rgb_illuminant(const Vec3& rgb);
    /// Returns D65 of luminance one, the white of sRGB.
    static Spectrum d65();

    float operator()(float nm) const;
    SampledSpectrum at(const Wavelengths& wavelengths) const;
    /// Returns the spectrum times a number.
    Spectrum scaled(float by) const { return Spectrum(kind_, factor_ * by); }
    bool is_constant() const { return std::holds_alternative<ConstantSpectrum>(kind_); }
    const Kind& kind() const { return kind_; }
    /// Returns the number by which kind() is multiplied.
    float factor() const { return factor_; }

    /// Returns the integral against CIE Y over 360..830 nm, divided by that of Y (106.857 nm): the
    /// luminance of a radiance. It is one for Spectrum::constant(1) and d65().
    float luminance() const;
    /// Returns linear sRGB in the scale of luminance().
    Vec3 to_rgb() const;

private:
    Kind kind_ = ConstantSpectrum{};
    float factor_ = 1;
};

/// Returns the spectrum of pbrt-v4's name, such as "metal-Au-eta", "glass-BK7", "stdillum-D65";
/// nothing for an unknown name.
std::optional<Spectrum> named_spectrum(const std::string& name);
/// Returns all names, sorted, for messages.
std::vector<std::string> named_spectra();

}  // namespace sunfleck::engine
