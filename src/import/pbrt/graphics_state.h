// GraphicsState: the state that AttributeBegin saves and AttributeEnd restores.
#pragma once

#include "import/pbrt/parameters.h"
#include "scene/description.h"

#include <array>

namespace sunfleck::engine {

/// The current matrix at the start and at the end of the exposure, object to world (before
/// WorldBegin: world to camera), for row vectors.
using Motion = std::array<Matrix, 2>;

struct GraphicsState {
    Motion matrix;
    std::array<bool, 2> active{true, true};  // which of both a transform changes
    bool reverse_orientation = false;
    std::uint32_t material = 0;  // index in the MaterialTable
    std::shared_ptr<const AreaEmission> emission;
    std::string inside_medium;  // empty for none
    std::string outside_medium;
    ColourSpace colour_space = ColourSpace::srgb;  // of the rgb parameters that follow

    /// Defaults from the directive Attribute, or null.
    std::shared_ptr<const Parameters> shape_defaults;
    std::shared_ptr<const Parameters> light_defaults;
    std::shared_ptr<const Parameters> material_defaults;
    std::shared_ptr<const Parameters> medium_defaults;
    std::shared_ptr<const Parameters> texture_defaults;
};

/// An open block: its name, its beginning, and the state to restore.
struct Block {
    std::string begin;  // "AttributeBegin", "TransformBegin" or "ObjectBegin"
    SourceLocation where;
    GraphicsState saved;
};

}  // namespace sunfleck::engine
