// Light groups as a user asks for them: which lights of a scene get an output of their own.
//
// Lights are counted as the scene's file states them, from 1: `sunfleck info --lights` lists them.
#pragma once

#include "aovs/light_groups.h"
#include "photon/settings.h"

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

/// NAME=1,3-5, or each. Names begin with a letter and go on with letters, digits, _ and -.
/// @throws Error for what is neither, for names that are taken, and for the sampler paper.
std::vector<AskedLightGroup> read_light_groups(const std::vector<std::string>& texts,
                                               PhotonSampler sampler);

/// @throws Error for lights that the scene does not have or that are asked for twice, and for more
///         groups than there may be.
LightGroups light_groups_of(const Scene& scene, const std::vector<AskedLightGroup>& asked);

}  // namespace sunfleck::engine
