// A spectrum as a scene gives it: a function of the wavelength, evaluated once a pass.
//
// A closed set of kinds, each a small value; tables are shared, not copied.
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

/// Linear between the points, zero outside (pbrt-v4). Points sorted by wavelength.
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

/// scale * sigmoid(c0 x^2 + c1 x + c2), x in nm: the smooth spectra of Jakob and Hanika (2019);
/// with `times_d65` multiplied by the D65 illuminant scaled to luminance one.
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
    /// @throws Error  when there is no point, or wavelengths do not rise (whoever knows the place
    /// in a file checks first).
    static Spectrum table(std::vector<TabulatedSpectrum::Point> points);
    /// Reflectance: the smooth spectrum in [0,1] that looks like rgb under D65.
    /// A grey is a ConstantSpectrum, exactly; another colour takes a fit of about 0.1 ms, and then
    /// looks as asked to 2e-5.
    /// @param rgb  linear sRGB; brought into [0,1], as are negative numbers below.
    static Spectrum rgb_albedo(const Vec3& rgb);
    /// Any non-negative quantity without an illuminant (eta, k): scale * smooth spectrum.
    static Spectrum rgb_unbounded(const Vec3& rgb);
    /// Emission: rgb_unbounded times D65 of luminance one, so that a pixel that sees it shows rgb.
    static Spectrum rgb_illuminant(const Vec3& rgb);
    /// The colour space's white, D65 of luminance one.
    static Spectrum d65();

    float operator()(float nm) const;
    SampledSpectrum at(const Wavelengths& wavelengths) const;
    /// The same curve times a number.
    Spectrum scaled(float by) const { return Spectrum(kind_, factor_ * by); }
    bool is_constant() const { return std::holds_alternative<ConstantSpectrum>(kind_); }
    const Kind& kind() const { return kind_; }

    /// Integral of the curve against CIE Y over 360..830 nm, divided by that of Y (106.857 nm):
    /// the luminance of a radiance, one for Spectrum::constant(1) and d65().
    float luminance() const;
    /// Linear sRGB in the same scale.
    Vec3 to_rgb() const;

private:
    Kind kind_ = ConstantSpectrum{};
    float factor_ = 1;
};

/// Spectra by pbrt-v4's names: "metal-Au-eta", "glass-BK7", "stdillum-D65", ...
/// @return nothing when there is none of that name.
std::optional<Spectrum> named_spectrum(const std::string& name);
/// All the names, sorted: for messages.
std::vector<std::string> named_spectra();

}  // namespace sunfleck::engine
