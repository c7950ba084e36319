// In closed form, or by a point of the way.
#include "medium/glow_along.h"

#include "medium/free_way.h"
#include "medium/stopping_medium.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

/// Returns the part of a thick medium's radiance that an amount of it has.
SampledSpectrum even_glow(const SampledMedium& medium, float amount) {
    SampledSpectrum light;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        const float extinction = medium.absorption[i] + medium.scattering[i];
        if (!(extinction > 0) || !(amount > 0)) continue;
        light[i] = medium.glow_radiance[i] * (medium.absorption[i] / extinction) *
                   -std::expm1(-extinction * amount);
    }
    return light;
}

}  // namespace

SampledSpectrum glow_at(const SampledMedium& medium, const Wavelengths& wavelengths,
                        const Vec3& point) {
    SampledSpectrum radiance = medium.glow_radiance * medium.glow->factor_at(point);
    if (medium.glow->heat) radiance *= Spectrum(medium.glow->black_body_at(point)).at(wavelengths);
    return radiance;
}

SampledSpectrum glow_along(const SampledMedium& medium, const Wavelengths& wavelengths,
                           const Ray& way, const SampledSpectrum& carried, float u) {
    if (!medium.glow->varies()) return even_glow(medium, amount(medium, way));
    const DensityGrid& power = *medium.glow->power;
    const float whole = power.amount(way);
    const SampledMedium stopping = stopping_medium(medium);
    const FreeWay back(stopping, way, carried);
    const float chance = back.chance();
    if (!(whole > 0) || !(chance > 0)) return {};
    const float distance =
        u < 0.5F ? power.distance_at(way, 2 * u * whole) : back.distance_at((2 * u - 1) * chance);
    const Vec3 point = way.origin + way.direction * distance;
    const float density = (power.at(point) / whole + back.density(distance) / chance) / 2;
    if (!(density > 0)) return {};
    return glow_at(medium, wavelengths, point) * medium.absorption *
           transmittance(medium, {way.origin, way.direction, distance}) *
           (density_at(medium, point) / density);
}

}  // namespace sunfleck::engine
