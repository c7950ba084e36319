// SurfaceDerivatives: partial derivatives of position and normal, the input of bump mapping.
#pragma once

#include "math/vector.h"

namespace sunfleck::engine {

/// Derivatives per unit of u and v of the shaded surface, in the world. With vertex normals or
/// given tangents, the tangents are perpendicular and of equal length, as in pbrt-v4.
struct SurfaceDerivatives {
    Vec3 dp_du{0};
    Vec3 dp_dv{0};
    Vec3 dn_du{0};  // of the shading normal; zero on shapes that are intersected exactly
    Vec3 dn_dv{0};
};

}  // namespace sunfleck::engine
