// Curves of the sky model as spectra and colours, in the scale of Spectrum::luminance().
#pragma once

#include "math/spectrum.h"
#include "sky/sky_model.h"

namespace sunfleck::engine {

/// Returns a + times * b.
inline SkyCurve sum_of(const SkyCurve& a, double times, const SkyCurve& b) {
    SkyCurve sum = a;
    for (std::size_t w = 0; w < kSkyWavelengths; ++w) sum[w] += times * b[w];
    return sum;
}

inline SkyCurve product_of(const SkyCurve& a, const SkyCurve& b) {
    SkyCurve product = a;
    for (std::size_t w = 0; w < kSkyWavelengths; ++w) product[w] *= b[w];
    return product;
}

/// Returns a curve per nanometre as a spectrum. Its luminance times 683 is in cd/m^2, or lux.
/// Beyond 720 nm, where the model ends, it stays as it is there.
Spectrum spectrum_of(const SkyCurve& curve);

/// Linear sRGB of curves. It is linear in the curve, so that a table of the model's wavelengths
/// does.
class CurveColours {
public:
    CurveColours();
    Vec3d operator()(const SkyCurve& curve) const;

private:
    std::array<Vec3d, kSkyWavelengths> of_one_;
};

}  // namespace sunfleck::engine
