// What a material makes of the surfaces of a part.
#pragma once

#include "light/lumens.h"
#include "scene/additions.h"
#include "scene/description.h"

#include <cstdint>
#include <optional>

namespace sunfleck::engine {

struct PartLook {
    std::uint32_t material = 0;  // index into SceneDescription::materials; of glass, where solid
    bool takes_vertex_colours = false;  // matt: each shape has a material of its own
    std::optional<AreaEmission> emission{};
    Cover cover{};                        // null: opaque
    std::optional<FloatTexture> alpha{};  // of `cover`, for emission
    struct Glass {
        std::uint32_t pane = 0;   // material where it is thin
        Vec3d filter{1};          // what a straight way through lets pass, linear sRGB
        MediumNumber medium = 0;  // within, if its absorption is known; 0 for none
    };
    std::optional<Glass> glass{};
};

}  // namespace sunfleck::engine
