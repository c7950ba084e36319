// Placements: rigid motions that move meshes from the origin to their position.
#pragma once

#include "math/vector.h"
#include "procedural/mesh.h"

namespace sunfleck::engine {

/// Local axes in the world, right-handed and of unit length, and the local origin.
struct Placement {
    Vec3d x{1, 0, 0};
    Vec3d y{0, 1, 0};
    Vec3d z{0, 0, 1};
    Vec3d origin{0, 0, 0};

    Vec3d operator()(const Vec3d& p) const { return origin + x * p.x + y * p.y + z * p.z; }
};

/// Returns a translation.
Placement at(const Vec3d& origin);

/// Returns a rotation about the z axis, from x towards y. @param revolutions  in revolutions.
Placement turned(double revolutions, const Vec3d& origin);

/// Returns a rotation about the x axis, from y towards z. @param revolutions  in revolutions; 1/4
/// raises what lies.
Placement tilted(double revolutions, const Vec3d& origin);

/// Returns the placement that raises the plane of x and y to that of x and z (local y becomes up,
/// local z, the front, becomes -y) and then rotates about the vertical. @param revolutions  in
/// revolutions.
Placement standing(double revolutions, const Vec3d& origin);

/// Returns the composition: `inner` first, then `outer`.
Placement operator*(const Placement& outer, const Placement& inner);

/// Returns the mesh after a placement, normals included. Points are rounded to float once.
Mesh placed(Mesh mesh, const Placement& placement);

std::array<float, 3> rounded_point(const Vec3d& p);

}  // namespace sunfleck::engine
