// Media: what fills the space between surfaces, absorbs light and scatters it.
//
// In:  curves of a scene. Out: the same at the wavelengths of a pass.
#pragma once

#include "bsdf/henyey_greenstein.h"
#include "geometry/ray.h"
#include "math/spectrum.h"
#include "medium/density.h"
#include "medium/glow.h"

#include <memory>

namespace sunfleck::engine {

struct Medium {
    Spectrum absorption;                               // per unit of length in the world
    Spectrum scattering;                               // the same
    float g = 0;                                       // of HenyeyGreenstein
    std::shared_ptr<const Density> density = nullptr;  // factor of both; null: one everywhere
    std::shared_ptr<const Glow> glow = nullptr;        // null: none
};

/// A medium at the wavelengths of a pass.
struct SampledMedium {
    SampledSpectrum absorption;
    SampledSpectrum scattering;
    HenyeyGreenstein phase;
    bool scatters = false;             // at any wavelength of any pass
    const Density* density = nullptr;  // of the Medium, which must outlive this
    const Glow* glow = nullptr;        // the same
    SampledSpectrum glow_radiance{};
};

/// Returns whether it scatters light at all.
inline bool scatters(const Medium& medium) {
    return medium.scattering.luminance() > 0;
}

inline SampledMedium sampled(const Medium& medium, const Wavelengths& wavelengths) {
    return {medium.absorption.at(wavelengths),
            medium.scattering.at(wavelengths),
            {medium.g},
            scatters(medium),
            medium.density.get(),
            medium.glow.get(),
            medium.glow ? medium.glow->radiance.at(wavelengths) : SampledSpectrum()};
}

/// Returns the integral of the density along a way, in units of length: light is absorbed and
/// scattered as on a way of that length where the density is one.
inline float amount(const SampledMedium& medium, const Ray& way) {
    return medium.density ? amount(*medium.density, way) : way.length;
}
/// Returns the distance on a way before which lies no more than an amount.
inline float distance_at(const SampledMedium& medium, const Ray& way, float amount) {
    return medium.density ? distance_at(*medium.density, way, amount) : amount;
}
/// Returns the density at a point.
inline float density_at(const SampledMedium& medium, const Vec3& point) {
    return medium.density ? density_at(*medium.density, point) : 1;
}

}  // namespace sunfleck::engine
