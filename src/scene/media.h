// Media between surfaces: they absorb by Beer's law and do not scatter.
//
// A path stays in its medium until it leaves a surface with different media on its sides (pbrt-v4).
#pragma once

#include "math/spectrum.h"
#include "math/vector.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Index into Media::absorption; 0 is empty space.
using MediumNumber = std::uint32_t;

/// The media on the two sides of a surface.
struct MediumSides {
    MediumNumber inside = 0;  // the side opposite to the normal
    MediumNumber outside = 0;

    /// Returns whether the media differ; if not, the surface does not define what is around it.
    bool differ() const { return inside != outside; }
    /// Returns the medium of a side.
    /// @param normal  geometric.
    /// @param direction  pointing away from the surface.
    MediumNumber towards(const Vec3& normal, const Vec3& direction) const {
        return normal.dot(direction) > 0 ? outside : inside;
    }
    friend bool operator==(const MediumSides&, const MediumSides&) = default;
};

/// All media of a scene, and those in which paths start.
struct Media {
    std::vector<Spectrum> absorption{Spectrum()};  // per unit of length in the world
    MediumNumber at_camera = 0;
    std::vector<MediumSides> at_lights;  // per light; those beyond the end are in empty space

    /// Returns whether any medium absorbs.
    bool absorb() const;
};

/// Returns the transmittance of a distance in a medium.
/// @param absorption  per unit of length, not negative.
/// @param distance  may be infinite: then every absorbed wavelength becomes zero.
inline SampledSpectrum transmittance(const SampledSpectrum& absorption, float distance) {
    SampledSpectrum left;
    for (std::size_t i = 0; i < kWavelengths; ++i)
        left[i] = absorption[i] > 0 ? std::exp(-absorption[i] * distance) : 1;
    return left;
}

}  // namespace sunfleck::engine
