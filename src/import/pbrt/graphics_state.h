// What AttributeBegin saves and AttributeEnd brings back.
#pragma once

#include "import/pbrt/parameters.h"
#include "scene/description.h"

#include <array>

namespace sunfleck::engine {

/// The current matrix at the start and at the end of the exposure, object to world (before
/// WorldBegin: world to camera), as row vectors have it.
using Motion = std::array<Matrix, 2>;

struct GraphicsState {
    Motion matrix;
    std::array<bool, 2> active{true, true};  // which of the two a transform changes
    bool reverse_orientation = false;
    std::uint32_t material = 0;  // slot of the MaterialTable
    std::shared_ptr<const AreaEmission> emission;
    std::string inside_medium;  // empty: none
    std::string outside_medium;
    ColourSpace colour_space = ColourSpace::srgb;  // of rgb parameters to come

    /// Defaults by the directive Attribute, or null.
    std::shared_ptr<const Parameters> shape_defaults;
    std::shared_ptr<const Parameters> light_defaults;
    std::shared_ptr<const Parameters> material_defaults;
    std::shared_ptr<const Parameters> medium_defaults;
    std::shared_ptr<const Parameters> texture_defaults;
};

/// A block that is open: its name, where it began, and what to bring back at its end.
struct Block {
    std::string begin;  // "AttributeBegin", "TransformBegin" or "ObjectBegin"
    SourceLocation where;
    GraphicsState saved;
};

}  // namespace sunfleck::engine
