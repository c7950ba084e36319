// How a surface goes on around a hit: what bumps are measured against.
#pragma once

#include "math/vector.h"

namespace sunfleck::engine {

/// In the world, per unit of u and of v, of the surface that shading sees: across vertex normals
/// and given tangents, tangents are perpendicular and of one length, as in pbrt-v4.
struct SurfaceDerivatives {
    Vec3 dp_du{0};
    Vec3 dp_dv{0};
    Vec3 dn_du{0};  // of the shading normal; zero on shapes that are intersected exactly
    Vec3 dn_dv{0};
};

}  // namespace sunfleck::engine
