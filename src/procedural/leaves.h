// Leaves between the sun and a place, with a gap through which the place is lit.
#pragma once

#include "math/vector.h"
#include "procedural/mesh.h"

namespace sunfleck::engine {

/// Lengths in the scene's unit; across the sun's direction unless said otherwise.
struct Canopy {
    Vec3d sun;               // unit vector to the sun, not vertical
    Vec3d place;             // centre of the lit place
    double gap_width = 8.5;  // half axes of the gap, an ellipse; no leaf reaches far into it
    double gap_height = 10.5;
    double half_width = 60;  // of the rectangle that the leaves are spread over
    double half_height = 55;
    double nearest = 50;  // along the sun's direction
    double farthest = 90;
    int leaves = 1500;
};

/// Returns the leaves: flat, 3.5 to 6 long, with random rotations.
Mesh canopy(const Canopy& canopy);

}  // namespace sunfleck::engine
