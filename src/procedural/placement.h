// Where a mesh stands: meshes are made around the origin, then moved and turned.
#pragma once

#include "math/vector.h"
#include "procedural/mesh.h"

namespace sunfleck::engine {

/// Local axes in the world, right-handed and of length one, and the local origin.
struct Placement {
    Vec3d x{1, 0, 0};
    Vec3d y{0, 1, 0};
    Vec3d z{0, 0, 1};
    Vec3d origin{0, 0, 0};

    Vec3d operator()(const Vec3d& p) const { return origin + x * p.x + y * p.y + z * p.z; }
};

/// Without turning.
Placement at(const Vec3d& origin);

/// Turned about the z axis, from x towards y. @param turns  of 360 degrees.
Placement turned(double turns, const Vec3d& origin);

/// Turned about the x axis, from y towards z: 1/4 lets what lies stand up.
Placement tilted(double turns, const Vec3d& origin);

/// What lies in the plane of x and y stands in that of x and z: local y becomes up, local z (the
/// side facing) becomes -y; then all is turned about the vertical.
Placement standing(double turns, const Vec3d& origin);

/// The inner one is carried along by the outer one.
Placement operator*(const Placement& outer, const Placement& inner);

/// Normals, if any, turn along. Points are rounded to float once.
Mesh placed(Mesh mesh, const Placement& placement);

std::array<float, 3> rounded_point(const Vec3d& p);

}  // namespace sunfleck::engine
