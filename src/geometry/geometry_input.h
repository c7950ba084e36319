// Input of a geometry: shapes, their placement, and objects with instances.
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
    Matrix to_world;        // object to world (or to the frame of the containing object)
    bool flip = false;      // true if the normal points to the other side of the object frame
    Cover cover = nullptr;  // alpha; null for an opaque shape
};

/// A set of shapes under one of possibly many matrices.
struct PlacedInstance {
    std::vector<std::uint32_t> shapes;  // indices into GeometryInput::shapes
    Matrix to_world;
    std::uint32_t object = 0;  // instances of one object share one Embree scene
};

struct GeometryInput {
    std::vector<PlacedShape> shapes;
    std::vector<std::uint32_t> in_world;  // indices of the shapes in the world
    std::vector<PlacedInstance> instances;

    /// Calls visit(number of the shape, frame around it) for each shape in the world and in each
    /// instance.
    template <class Visit>
    void for_each_placed(const Visit& visit) const {
        for (const std::uint32_t shape : in_world) visit(shape, Matrix());
        for (const PlacedInstance& instance : instances)
            for (const std::uint32_t shape : instance.shapes) visit(shape, instance.to_world);
    }
};

}  // namespace sunfleck::engine
