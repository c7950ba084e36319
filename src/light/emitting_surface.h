// The surfaces of area lights, one emitting triangle, bilinear patch, sphere, cylinder or disk
// each: points spread over them, and how densely.
//
// In:  u in (0,1)^2, in double. Out: world positions, normals, areas. Triangles, disks, flat
// patches, similar images of spheres and cylinders are covered uniformly by area. A sphere or
// cylinder under any other matrix is covered uniformly in its own frame, a patch that is not flat
// by the densities at its corners, bilinear between them: `spread` then varies over it.
// The maps are continuous; sectors and rings have one seam at azimuth 0, full spheres and disks
// none.
#pragma once

#include "geometry/bilinear.h"
#include "geometry/cylinder.h"
#include "geometry/disk.h"
#include "geometry/sphere.h"

#include <array>
#include <optional>
#include <variant>

namespace sunfleck::engine {

/// A triangle in the world's frame. Emits on the side of `normal` (unit, geometric).
struct EmittingTriangle {
    Vec3d p0;
    Vec3d edge1;  // p1 - p0
    Vec3d edge2;  // p2 - p0
    Vec3d normal;
};

/// A bilinear patch in the world's frame. Emits on the side of dP/du x dP/dv, or on the other.
struct EmittingPatch {
    Bilinear surface;
    bool flip = false;
    /// Of the corners, on the side that emits, any length: they decide the side of each point.
    std::array<Vec3d, 4> normals{Vec3d(0), Vec3d(0), Vec3d(0), Vec3d(0)};  // zeros: none
};

/// A sphere, cylinder or disk of its own frame, placed in the world by any affine matrix (area and
/// density are those of the world). `flip` emits on the other side.
template <class Quadric>
struct EmittingQuadric {
    Quadric shape;
    Matrix to_world;
    bool flip = false;
};

using EmittingSurface = std::variant<EmittingTriangle, EmittingPatch, EmittingQuadric<Sphere>,
                                     EmittingQuadric<Cylinder>, EmittingQuadric<Disk>>;

struct SurfaceSample {
    Vec3d position;
    Vec3d normal;       // unit; the side of Hit::normal, flip included
    double spread = 0;  // 1 / density, m^2; uniform: the area
};

SurfaceSample sample_surface(const EmittingTriangle& triangle, const Vec2d& u);
SurfaceSample sample_surface(const EmittingPatch& patch, const Vec2d& u);
SurfaceSample sample_surface(const EmittingQuadric<Sphere>& sphere, const Vec2d& u);
SurfaceSample sample_surface(const EmittingQuadric<Cylinder>& cylinder, const Vec2d& u);
SurfaceSample sample_surface(const EmittingQuadric<Disk>& disk, const Vec2d& u);
inline SurfaceSample sample_surface(const EmittingSurface& surface, const Vec2d& u) {
    return std::visit([&](const auto& s) { return sample_surface(s, u); }, surface);
}

/// The u that sample_surface() takes to the point `on` of the surface, where its unit world normal
/// (either side) is `normal`: its inverse.
Vec2d surface_square(const EmittingTriangle& triangle, const Vec3d& on, const Vec3d& normal);
Vec2d surface_square(const EmittingPatch& patch, const Vec3d& on, const Vec3d& normal);
Vec2d surface_square(const EmittingQuadric<Sphere>& sphere, const Vec3d& on, const Vec3d& normal);
Vec2d surface_square(const EmittingQuadric<Cylinder>& cylinder, const Vec3d& on,
                     const Vec3d& normal);
Vec2d surface_square(const EmittingQuadric<Disk>& disk, const Vec3d& on, const Vec3d& normal);
inline Vec2d surface_square(const EmittingSurface& surface, const Vec3d& on, const Vec3d& normal) {
    return std::visit([&](const auto& s) { return surface_square(s, on, normal); }, surface);
}

/// SurfaceSample::spread at the point `on` of the surface, where its unit world normal (either
/// side) is `normal`.
double surface_spread(const EmittingTriangle& triangle, const Vec3d& on, const Vec3d& normal);
double surface_spread(const EmittingPatch& patch, const Vec3d& on, const Vec3d& normal);
double surface_spread(const EmittingQuadric<Sphere>& sphere, const Vec3d& on, const Vec3d& normal);
double surface_spread(const EmittingQuadric<Cylinder>& cylinder, const Vec3d& on,
                      const Vec3d& normal);
double surface_spread(const EmittingQuadric<Disk>& disk, const Vec3d& on, const Vec3d& normal);

/// World area, m^2.
double surface_area(const EmittingTriangle& triangle);
double surface_area(const EmittingPatch& patch);
template <class Quadric>
double surface_area(const EmittingQuadric<Quadric>& surface) {
    return surface.shape.area(Affine(surface.to_world));
}

/// Does the normal of a sphere point inwards? Asked of spheres alone: false for all others.
template <class Surface>
bool is_flipped(const Surface&) {
    return false;
}
inline bool is_flipped(const EmittingQuadric<Sphere>& sphere) {
    return sphere.flip;
}

/// How far along its normal a ray that starts at the point must be moved, so that rounding to
/// float leaves it on its side of the surface.
float surface_error(const EmittingTriangle& triangle, const SurfaceSample& on);
float surface_error(const EmittingPatch& patch, const SurfaceSample& on);
float surface_error(const EmittingQuadric<Sphere>& sphere, const SurfaceSample& on);
float surface_error(const EmittingQuadric<Cylinder>& cylinder, const SurfaceSample& on);
float surface_error(const EmittingQuadric<Disk>& disk, const SurfaceSample& on);

/// The part of a whole sphere that a point outside it sees, as a cone of directions.
struct VisibleCap {
    Vec3d axis;           // unit, to the centre
    double distance = 0;  // to the centre
    double radius = 0;
    double versine = 0;  // 1 - cos of the cone's half angle
};

/// Nothing for parts of spheres, for matrices that are no similarity, from inside, and at a point
/// of the sphere itself.
std::optional<VisibleCap> visible_cap(const EmittingQuadric<Sphere>& sphere, const Vec3d& point);
template <class Surface>
std::optional<VisibleCap> visible_cap(const Surface&, const Vec3d&) {
    return {};
}

}  // namespace sunfleck::engine
