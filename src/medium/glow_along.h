// The light of a medium's glow along a way.
#pragma once

#include "medium/medium.h"

namespace sunfleck::engine {

/// Returns E at a point.
SampledSpectrum glow_at(const SampledMedium& medium, const Wavelengths& wavelengths,
                        const Vec3& point);

/// Returns what arrives at the begin of a way of the light that its medium emits. It is exact where
/// E does not vary; else an estimate from one point of the way, drawn by half where the medium
/// glows, by half where light from there arrives.
/// @param way  its length may be infinite.
/// @param carried  what light is multiplied with that arrives.
/// @param u  in [0,1).
SampledSpectrum glow_along(const SampledMedium& medium, const Wavelengths& wavelengths,
                           const Ray& way, const SampledSpectrum& carried, float u);

}  // namespace sunfleck::engine
