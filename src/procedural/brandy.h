// The scene brandy: a snifter of brandy on a striped cloth, in a gap of the leaves' shade.
#pragma once

#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Returns the scene file and its meshes: three surfaces of glass and brandy, and the leaves. The
/// unit is the centimetre, z is up.
std::vector<SceneFile> brandy_scene();

/// Index of refraction of the glass, whose dispersion is left out.
inline constexpr double kSnifterIndex = 1.52;

/// Index of refraction of brandy: Cauchy's formula with the index of 40% of ethanol in water and
/// the dispersion of water (Abbe number 58). @param wavelength  in micrometres.
inline double brandy_index(double wavelength) {
    return 1.3463 + 0.0032 / (wavelength * wavelength);
}

}  // namespace sunfleck::engine
