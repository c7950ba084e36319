// The scenes cognac-0 ... cognac-6: a snifter of brandy in the sun, and six closer looks at its
// caustic.
#pragma once

#include "procedural/close_up.h"
#include "procedural/mesh.h"
#include "procedural/scene_file.h"

#include <array>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// Half the side of the square table in cm. It sets the visible fraction of uniform photon paths in
/// cognac-0: the sun emits from a disc over the bounding sphere of the scene, whose radius is about
/// sqrt(2) times this, so the visible fraction is proportional to its inverse square. The cameras
/// set the fractions of the other scenes.
inline constexpr double kTableHalfWidth = 31;

/// Fractions of uniform photon paths that reach the view after refraction or reflection (estimated,
/// table reflectance 0.5): 1e-2, 2.7e-3, 1.1e-3, 1.1e-3, 3e-4, 1e-5, 1e-6.
inline constexpr std::array<CloseUp, 7> kCognacViews = {{
    {"cognac-0", "a glass of brandy in the sun and its caustic on the table", "2.2 -3.4 3.2", "31"},
    {"cognac-1", "the caustic of cognac-0, filling the picture", "3.1 -6.6 0", "7.5"},
    {"cognac-2", "the same, closer: light folded by the bowl", "4.3 -8.4 0", "5"},
    {"cognac-3", "moved sideways: the sun gathered by the brandy", "2.2 -5.1 0", "3.5"},
    {"cognac-4", "one fold of cognac-2: the facets of the glass show", "4.6 -8 0", "2.2"},
    {"cognac-5", "two millimetres of cognac-4", "4.6 -8 0", "0.33"},
    {"cognac-6", "two thirds of a millimetre of cognac-4", "4.6 -8 0", "0.1"},
}};

/// The table that the scenes have.
inline Mesh cognac_table() {
    return square_mesh(static_cast<float>(kTableHalfWidth), 0);
}

/// Returns the files of one scene. @param view  one of kCognacViews. @param table  another one
/// shows what the surround costs.
std::vector<SceneFile> cognac_scene(const CloseUp& view, const Mesh& table = cognac_table());

}  // namespace sunfleck::engine
