// How much of unpolarised light a plane boundary reflects: exact, for glass and for metal.
//
// Source: Born and Wolf, Principles of Optics (7th ed.), 1.5.2 and 14.2. Mean of the two
// polarisations.
#pragma once

#include "math/sampled_spectrum.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {

/// The cosine on the far side of the boundary; 0 under total reflection.
/// @param sin2  squared sine of the incident angle. @param eta  far index over near index, > 0.
inline float refracted_cosine(float sin2, float eta) {
    return std::sqrt(std::max(0.0F, 1 - sin2 / (eta * eta)));
}

/// Reflected fraction in [0,1] between two dielectrics, 1 under total reflection (cos_far 0).
/// @param cos_near  in (0,1]. @param cos_far  refracted_cosine(). @param eta  far over near.
inline float dielectric_reflectance(float cos_near, float cos_far, float eta) {
    const float parallel = (eta * cos_near - cos_far) / (eta * cos_near + cos_far);
    const float across = (cos_near - eta * cos_far) / (cos_near + eta * cos_far);
    return 0.5F * (parallel * parallel + across * across);
}

/// The same from the incident cosine alone. @param cos_near  in (0,1].
inline float dielectric_reflectance(float cos_near, float eta) {
    const float sin2 = std::max(0.0F, 1 - cos_near * cos_near);
    return dielectric_reflectance(cos_near, refracted_cosine(sin2, eta), eta);
}

/// Mean of dielectric_reflectance() over evenly spread light, to 0.006 for eta in [1/4, 4].
/// Source: the fit of Kulla and Conty, Revisiting Physically Based Shading at Imageworks (2017);
/// from the denser side by what passes, which differs by eta^2. @param eta  far over near, > 0.
inline float mean_dielectric_reflectance(float eta) {
    const float up = std::max(eta, 1 / eta);
    const float passed = 1 - (up - 1) / (4.08567F + 1.00071F * up);
    return 1 - (eta < 1 ? passed * eta * eta : passed);
}

/// Reflected fraction per wavelength of a metal of index eta + i k (over that of air), in [0,1].
/// @param cosine  of the incident angle, in (0,1]. @param eta, k  not negative, not both zero.
///
/// With a + i b = sqrt((eta + i k)^2 - sin^2): |r_s|^2 = |cos - a - i b|^2 / |cos + a + i b|^2,
/// and |r_p|^2 = |r_s|^2 |cos (a + i b) - sin^2|^2 / |cos (a + i b) + sin^2|^2.
inline SampledSpectrum conductor_reflectance(float cosine, const SampledSpectrum& eta,
                                             const SampledSpectrum& k) {
    const float cos2 = cosine * cosine;
    const float sin2 = std::max(0.0F, 1 - cos2);
    SampledSpectrum reflectance;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        const float real = eta[i] * eta[i] - k[i] * k[i] - sin2;
        const float imaginary = 2 * eta[i] * k[i];
        const float norm = std::sqrt(real * real + imaginary * imaginary);  // a^2 + b^2
        const float a = std::sqrt(std::max(0.0F, 0.5F * (norm + real)));

        const float even = norm + cos2;
        const float odd = 2 * cosine * a;
        const float across = (even - odd) / (even + odd);

        const float even_p = cos2 * norm + sin2 * sin2;
        const float odd_p = odd * sin2;
        const float parallel = even_p > 0 ? across * (even_p - odd_p) / (even_p + odd_p) : across;
        reflectance[i] = std::max(0.0F, 0.5F * (across + parallel));
    }
    return reflectance;
}

}  // namespace sunfleck::engine
