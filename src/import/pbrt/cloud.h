// Clouds of noise, as pbrt-v4's medium "cloud".
#pragma once

#include "medium/density_grid.h"

namespace sunfleck::engine {

struct CloudShape {
    float density = 1;
    float wispiness = 1;  // how far noise shifts noise
    float frequency = 5;  // of the coarsest noise, per unit of length
};

/// Returns the density of a cloud at a point of its own coordinates, in [0, 1]; it falls with y.
/// Source: pbrt-v4 (Pharr, Jakob, Humphreys, 2023), CloudMedium.
float cloud_at(const CloudShape& shape, const Vec3& point);

/// Returns the density within a box, by samples of it: linear between points half as far apart as
/// the finest noise repeats, but at most 160 along an axis. docs/method/media-fields.md has the
/// error.
/// @param box  from the unit cube to the cloud's own coordinates; its axes are theirs.
DensityGrid cloud_density(const CloudShape& shape, const Affine& box, const Affine& to_world);

}  // namespace sunfleck::engine
