// Tabulated spectra of curves.
#include "sky/curves.h"

namespace sunfleck::engine {
namespace {

/// Integral of CIE Y, in nm: a spectrum of one per so many nanometres has luminance one.
constexpr double kLuminousWidth = 106.856895;
constexpr float kLastVisible = 830;  // nm

}  // namespace

Spectrum spectrum_of(const SkyCurve& curve) {
    std::vector<TabulatedSpectrum::Point> points;
    for (std::size_t w = 0; w < kSkyWavelengths; ++w)
        points.push_back(
            {static_cast<float>(sky_wavelength(w)), static_cast<float>(curve[w] * kLuminousWidth)});
    points.push_back({kLastVisible, points.back().value});
    return Spectrum::table(std::move(points));
}

CurveColours::CurveColours() {
    for (std::size_t w = 0; w < kSkyWavelengths; ++w) {
        SkyCurve one{};
        one[w] = 1;
        of_one_[w] = Vec3d(spectrum_of(one).to_rgb());
    }
}

Vec3d CurveColours::operator()(const SkyCurve& curve) const {
    Vec3d rgb(0);
    for (std::size_t w = 0; w < kSkyWavelengths; ++w) rgb += of_one_[w] * curve[w];
    return rgb;
}

}  // namespace sunfleck::engine
