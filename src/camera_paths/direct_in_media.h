// Who brings the light that comes straight from lights to a medium: light samples, or photons.
//
// Where most of a ray is lit, a light sample at one of its points is right at once. In the beam of
// a keyhole hardly any sample lies, while photons go there. Each brings a share; both shares of a
// piece of a ray sum to one.
// In:  what trials have found. Out: the share of photons.
// Equations: docs/method/media.md, eqs. (47) and (48).
#pragma once

#include <algorithm>
#include <cstdint>

namespace sunfleck::engine {

/// What trials have found of light that comes straight to media.
struct DirectInMedia {
    float photons = 0;  // of a pass, per unit of volume where there are any
    float lit = 0;      // part of the light samples that any light reaches, on rays that are lit
};

/// What light samples in media have found on the camera path of a pixel.
enum class Lit : std::uint8_t { not_sampled, dark, lit };

/// Returns the share of photons in a cylinder, by the power heuristic of what both would have as
/// relative variance, if all that is lit were lit alike.
/// @param expected  photons in the cylinder. @param chance  that the cylinder is at a given piece.
inline float share_of_photons(float lit, float expected, float chance) {
    if (!(expected > 0)) return 0;
    const float of_samples = 1 - lit;  // times 1 / lit, as what follows
    const float met = std::min(1.0F, lit + chance);
    const float of_photons = (met > 0 ? lit / met : 1) - lit + 1 / expected;
    const float square = of_samples * of_samples;
    return square / (square + of_photons * of_photons);
}

}  // namespace sunfleck::engine
