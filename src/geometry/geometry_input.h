// The input of a geometry: shapes, where they stand, and objects that stand in many places.
#pragma once

#include "geometry/alpha_test.h"
#include "geometry/shape.h"
#include "math/vector.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// One shape in the world or in an object.
struct PlacedShape {
    Shape shape;
    Matrix to_world;        // object frame to world (or to the frame of the object that holds it)
    bool flip = false;      // the normal side is the other one of the object frame
    Cover cover = nullptr;  // null: all of it is there
};

/// Shapes, once, under many matrices.
struct PlacedInstance {
    std::vector<std::uint32_t> shapes;  // indices into GeometryInput::shapes
    Matrix to_world;
    std::uint32_t object = 0;  // instances of one object share one Embree scene
};

struct GeometryInput {
    std::vector<PlacedShape> shapes;
    std::vector<std::uint32_t> in_world;  // indices of the shapes that stand in the world
    std::vector<PlacedInstance> instances;
};

}  // namespace sunfleck::engine
