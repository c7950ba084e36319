// Fresnel's equations as textbooks have them, in complex double: the truth for the tests.
#pragma once

#include "math/sampled_spectrum.h"

#include <cmath>
#include <complex>

namespace sunfleck::engine::laws {

/// Reflected fraction of unpolarised light. @param index  far over near, eta + i k.
inline double fresnel(double cosine, std::complex<double> index) {
    const std::complex<double> cos_far = std::sqrt(1.0 - (1 - cosine * cosine) / (index * index));
    const auto across = (cosine - index * cos_far) / (cosine + index * cos_far);
    const auto parallel = (index * cosine - cos_far) / (index * cosine + cos_far);
    return (std::norm(across) + std::norm(parallel)) / 2;
}

}  // namespace sunfleck::engine::laws
