// Products of spectra that stay within the range of floats.
#pragma once

#include "core/float_range.h"
#include "math/spectrum.h"

#include <optional>

namespace sunfleck::engine {

/// Returns the curve times a factor; nothing if that is no finite float.
/// @param peak  the largest number by which the product will be multiplied.
inline std::optional<Spectrum> finite_product(const Spectrum& curve, double factor,
                                              double peak = 1) {
    if (!is_finite_float(factor)) return {};
    const Spectrum product = curve.scaled(static_cast<float>(factor));
    if (!is_finite_float(double{product.luminance()} * peak)) return {};
    return product;
}

}  // namespace sunfleck::engine
