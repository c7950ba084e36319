// The scenes cognac-0 ... cognac-6: a snifter of brandy in the sun, and six closer looks at its
// caustic.
#pragma once

#include "procedural/scene_file.h"

#include <array>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// Half the side of the square table, in cm: the one number that sets which share of uniformly
/// emitted photon paths is visible in cognac-0. The sun shines from a disc over the bounding
/// sphere of the scene, whose radius is about sqrt(2) times this; the visible share falls with its
/// square. The views set the shares of the others.
inline constexpr double kTableHalfWidth = 31;

/// One look at the scene. Numbers are kept as the text that the scene file gets.
struct CognacView {
    std::string_view name;
    std::string_view what;
    std::string_view target;  // point that the camera looks at, cm
    std::string_view fov;     // degrees
};

/// Shares of uniformly emitted photon paths that land in view after the glass or the table turned
/// them (estimated, table reflectance 0.5): 1e-2, 2.7e-3, 1.1e-3, 1.1e-3, 3e-4, 1e-5, 1e-6.
inline constexpr std::array<CognacView, 7> kCognacViews = {{
    {"cognac-0", "a glass of brandy in the sun and its caustic on the table", "2.2 -3.4 3.2", "31"},
    {"cognac-1", "the caustic of cognac-0, filling the picture", "3.1 -6.6 0", "7.5"},
    {"cognac-2", "the same, closer: light folded by the bowl", "4.3 -8.4 0", "5"},
    {"cognac-3", "moved sideways: the sun gathered by the brandy", "2.2 -5.1 0", "3.5"},
    {"cognac-4", "one fold of cognac-2: the facets of the glass show", "4.6 -8 0", "2.2"},
    {"cognac-5", "two millimetres of cognac-4", "4.6 -8 0", "0.33"},
    {"cognac-6", "two thirds of a millimetre of cognac-4", "4.6 -8 0", "0.1"},
}};

/// The files of one view. @param view  one of kCognacViews.
std::vector<SceneFile> cognac_scene(const CognacView& view);

}  // namespace sunfleck::engine
