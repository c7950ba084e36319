// Evaluation of the kinds of spectra, the colours that they look like, and spectra from colours.
#include "math/spectrum.h"

#include "math/colour.h"
#include "math/sigmoid_fit.h"
#include "sunfleck/error.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {

namespace {

float value_at(const ConstantSpectrum& curve, float) {
    return curve.value;
}

float value_at(const TabulatedSpectrum& curve, float nm) {
    if (!curve.points || curve.points->empty()) return 0;
    const auto& points = *curve.points;
    if (!(nm >= points.front().nm && nm <= points.back().nm)) return 0;
    const auto above = std::upper_bound(points.begin(), points.end(), nm,
                                        [](float x, const auto& point) { return x < point.nm; });
    if (above == points.end()) return points.back().value;
    const auto& low = *(above - 1);
    const float part = (nm - low.nm) / (above->nm - low.nm);
    return low.value * (1 - part) + above->value * part;
}

/// Planck's law divided by its maximum, both written in x = h c / (nm k T).
float value_at(const BlackbodySpectrum& curve, float nm) {
    constexpr float kSecondRadiation = 1.43877733e7F;  // h c / k in nm K, with pbrt-v4's constants
    constexpr float kPeak = 4.96511423F;               // x at the maximum (Wien)
    constexpr float kPeakExp = 142.324893F;            // exp(kPeak) - 1
    if (!(curve.kelvin > 0)) return 0;
    const float x = kSecondRadiation / (nm * curve.kelvin);
    const float share = x / kPeak;
    const float growth = std::exp(std::min(x, 88.0F)) - 1;
    if (!(x < 88) || !(growth > 0)) return 0;
    return share * share * share * share * share * (kPeakExp / growth);
}

float white_at(float nm) {
    const float position = std::clamp(nm - kFirstNm, 0.0F, float{kLastNm - kFirstNm});
    const std::size_t cell = std::min(static_cast<std::size_t>(position), kVisibleCount - 2);
    const float part = position - static_cast<float>(cell);
    return static_cast<float>(white()[cell]) * (1 - part) +
           static_cast<float>(white()[cell + 1]) * part;
}

float value_at(const SigmoidSpectrum& curve, float nm) {
    const auto& c = curve.coefficients;
    const float reflectance = curve.scale * sigmoid((c[0] * nm + c[1]) * nm + c[2]);
    return curve.times_d65 ? reflectance * white_at(nm) : reflectance;
}

/// No negative numbers, no NaN, and nothing above `most`.
Triple usable(const Vec3& rgb, double most) {
    Triple clamped{};
    for (int i = 0; i < 3; ++i)
        if (rgb[i] > 0) clamped[static_cast<std::size_t>(i)] = std::min(double{rgb[i]}, most);
    return clamped;
}

bool is_grey(const Triple& rgb) {
    return rgb[0] == rgb[1] && rgb[1] == rgb[2];
}

SigmoidSpectrum smooth(const Triple& rgb) {
    const Triple c = fit_sigmoid(rgb);
    return {{static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])}};
}

/// Any non-negative colour that is not grey, as pbrt-v4 has it: the smooth reflectance of half
/// its brightest component, times the rest.
SigmoidSpectrum scaled_smooth(Triple rgb) {
    const double scale = 2 * *std::max_element(rgb.begin(), rgb.end());
    for (double& value : rgb) value /= scale;
    SigmoidSpectrum curve = smooth(rgb);
    curve.scale = static_cast<float>(scale);
    return curve;
}

constexpr double kNoLimit = 1e30;

}  // namespace

Spectrum Spectrum::table(std::vector<TabulatedSpectrum::Point> points) {
    const auto bad = [](const TabulatedSpectrum::Point& a, const TabulatedSpectrum::Point& b) {
        return !(a.nm < b.nm);
    };
    const bool sorted = std::adjacent_find(points.begin(), points.end(), bad) == points.end();
    if (points.empty() || !sorted)
        throw Error({"spectrum", 0, 0},
                    "a table without points, or with wavelengths that do not rise",
                    "give pairs of wavelength (nm) and value, wavelengths rising");
    return Spectrum(TabulatedSpectrum{
        std::make_shared<const std::vector<TabulatedSpectrum::Point>>(std::move(points))});
}

Spectrum Spectrum::rgb_albedo(const Vec3& rgb) {
    const Triple colour = usable(rgb, 1);
    if (is_grey(colour)) return constant(static_cast<float>(colour[0]));
    return Spectrum(smooth(colour));
}

Spectrum Spectrum::rgb_unbounded(const Vec3& rgb) {
    const Triple colour = usable(rgb, kNoLimit);
    if (is_grey(colour)) return constant(static_cast<float>(colour[0]));
    return Spectrum(scaled_smooth(colour));
}

Spectrum Spectrum::rgb_illuminant(const Vec3& rgb) {
    const Triple colour = usable(rgb, kNoLimit);
    if (is_grey(colour)) return d65().scaled(static_cast<float>(colour[0]));
    SigmoidSpectrum curve = scaled_smooth(colour);
    curve.times_d65 = true;
    return Spectrum(curve);
}

Spectrum Spectrum::d65() {
    static const Spectrum curve = [] {
        std::vector<TabulatedSpectrum::Point> points;
        for (std::size_t i = 0; i < kVisibleCount; i += 5) {
            points.push_back({kFirstNm + static_cast<float>(i), static_cast<float>(white()[i])});
        }
        return table(std::move(points));
    }();
    return curve;
}

float Spectrum::operator()(float nm) const {
    return factor_ * std::visit([nm](const auto& kind) { return value_at(kind, nm); }, kind_);
}

SampledSpectrum Spectrum::at(const Wavelengths& wavelengths) const {
    SampledSpectrum spectrum;
    for (std::size_t wavelength = 0; wavelength < kWavelengths; ++wavelength)
        spectrum[wavelength] = (*this)(wavelengths.nm[wavelength]);
    return spectrum;
}

float Spectrum::luminance() const {
    double sum = 0;
    for (std::size_t i = 0; i < kVisibleCount; ++i)
        sum += luminance_response()[i] * double{(*this)(kFirstNm + static_cast<float>(i))};
    return static_cast<float>(sum);
}

Vec3 Spectrum::to_rgb() const {
    Triple sum{};
    for (std::size_t i = 0; i < kVisibleCount; ++i) {
        const double value{(*this)(kFirstNm + static_cast<float>(i))};
        for (std::size_t k = 0; k < 3; ++k) sum[k] += rgb_response()[i][k] * value;
    }
    return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

}  // namespace sunfleck::engine
