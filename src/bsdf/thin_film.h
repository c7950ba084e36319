// Reflectance of a metal under a thin transparent film, whose two faces interfere.
//
// Source: Airy's sum; Born and Wolf, Principles of Optics (7th ed.), 1.6.4 and 14.4.
#pragma once

#include "bsdf/fresnel.h"
#include "math/trigonometry.h"

#include <complex>

namespace sunfleck::engine {

/// A film in air. All numbers are per wavelength, but its index.
struct ThinFilm {
    float eta = 1.33F;      // index of the film over that of the air, at least 1
    SampledSpectrum waves;  // thickness over the wavelength in the air
};

/// Returns the reflectance in [0,1] per wavelength, the mean of both polarisations.
/// @param cosine  of the incident angle in the air, in (0,1].
/// @param eta, k  index of the metal over that of the air; not negative, not both zero.
///
/// With r the amplitude of the upper face, s that of the lower, and p the phase of a way down and
/// up within the film: |r + s e^{ip}|^2 / |1 + r s e^{ip}|^2.
inline SampledSpectrum film_reflectance(float cosine, const ThinFilm& film,
                                        const SampledSpectrum& eta, const SampledSpectrum& k) {
    using Complex = std::complex<float>;
    const float sin2 = std::max(0.0F, 1 - cosine * cosine);
    const float inside = refracted_cosine(sin2, film.eta);
    const float across = (cosine - film.eta * inside) / (cosine + film.eta * inside);
    const float parallel = (film.eta * cosine - inside) / (film.eta * cosine + inside);
    SampledSpectrum reflectance;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        // The metal's index times the cosine within it is a + i b.
        const float real = eta[i] * eta[i] - k[i] * k[i];
        const float imaginary = 2 * eta[i] * k[i];
        const float shifted = real - sin2;
        const float norm = std::sqrt(shifted * shifted + imaginary * imaginary);
        const Complex far(std::sqrt(std::max(0.0F, 0.5F * (norm + shifted))),
                          std::sqrt(std::max(0.0F, 0.5F * (norm - shifted))));
        const SinCos phase =
            sin_cos_2pi(static_cast<double>(2 * film.waves[i] * film.eta * inside));
        const Complex turn(static_cast<float>(phase.cos), static_cast<float>(phase.sin));
        const auto both = [&](float above, const Complex& below) {
            const Complex later = below * turn;
            const float low = std::norm(1.0F + above * later);
            return low > 0 ? std::min(1.0F, std::norm(above + later) / low) : 1.0F;
        };
        const Complex index2(real, imaginary);
        const float near = film.eta * inside;
        reflectance[i] = 0.5F * (both(across, (near - far) / (near + far)) +
                                 both(parallel, (index2 * inside - film.eta * far) /
                                                    (index2 * inside + film.eta * far)));
    }
    return reflectance;
}

}  // namespace sunfleck::engine
