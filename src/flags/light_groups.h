// Parses the light groups that a user asks for: lights of a scene with an output of their own.
//
// Lights are numbered from 1 in the order of the scene file: `sunfleck info --lights` lists them.
#pragma once

#include "aovs/light_groups.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace sunfleck::engine {

class Scene;

/// One flag --light-group. Without a name: each light is a group.
struct AskedLightGroup {
    std::string name;
    std::string text;                                           // of the lights, as written
    std::vector<std::pair<std::uint32_t, std::uint32_t>> runs;  // of numbers, first to last
};

/// Adds NAME=1,3-5, or each. Names begin with a letter and go on with letters, digits, _ and -.
/// @throws Error for what is neither, for names that are taken, and for each beside others.
void add_light_group(const std::string& text, std::vector<AskedLightGroup>& groups);

/// @throws Error for lights that the scene does not have or that are asked for twice, and for more
///         groups than there may be.
LightGroups light_groups_of(const Scene& scene, const std::vector<AskedLightGroup>& asked);

}  // namespace sunfleck::engine
