// Media between surfaces: they absorb by Beer's law, and scatter nothing.
//
// A path keeps its medium until it leaves a surface with different media on its sides (pbrt-v4).
#pragma once

#include "math/spectrum.h"
#include "math/vector.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Place in Media::absorption; 0 is empty space.
using MediumNumber = std::uint32_t;

/// What is on the two sides of a surface.
struct MediumSides {
    MediumNumber inside = 0;  // the side that the normal points away from
    MediumNumber outside = 0;

    /// If it does not part two media, a surface says nothing of what is around it.
    bool parts() const { return inside != outside; }
    /// @param normal  geometric. @param direction  away from the surface.
    MediumNumber towards(const Vec3& normal, const Vec3& direction) const {
        return normal.dot(direction) > 0 ? outside : inside;
    }
    friend bool operator==(const MediumSides&, const MediumSides&) = default;
};

/// All media of a scene, and who starts where.
struct Media {
    std::vector<Spectrum> absorption{Spectrum()};  // per unit of the world's length
    MediumNumber at_camera = 0;
    std::vector<MediumSides> at_lights;  // by light; empty space where there are fewer

    /// Does any of them absorb?
    bool absorb() const;
};

/// Share of the light that is left after a way through a medium. @param absorption  per unit of
/// length, not negative. @param distance  may be infinite: then all is absorbed that can be.
inline SampledSpectrum transmittance(const SampledSpectrum& absorption, float distance) {
    SampledSpectrum left;
    for (std::size_t i = 0; i < kWavelengths; ++i)
        left[i] = absorption[i] > 0 ? std::exp(-absorption[i] * distance) : 1;
    return left;
}

}  // namespace sunfleck::engine
