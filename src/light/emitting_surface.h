// EmittingSurface: the surface of an area light (triangle, bilinear patch, sphere, cylinder or
// disk), with sampling of its points.
//
// In:  u in (0,1)^2, in double. Out: world positions, normals, areas.
// Triangles, disks, planar patches, and similar images of spheres and cylinders are sampled
// uniformly by area. A sphere or cylinder under another matrix is sampled uniformly in its own
// frame; a patch that is not planar, by a bilinear interpolation of the densities at its corners.
// `spread` then varies over the surface.
// The maps are continuous; sectors and rings have one seam at azimuth 0, full spheres and disks
// have none.
#pragma once

#include "geometry/bilinear.h"
#include "geometry/cylinder.h"
#include "geometry/disk.h"
#include "geometry/sphere.h"

#include <array>
#include <optional>
#include <variant>

namespace sunfleck::engine {

/// A triangle in the world. It emits on the side of `normal` (unit, geometric).
struct EmittingTriangle {
    Vec3d p0;
    Vec3d edge1;  // p1 - p0
    Vec3d edge2;  // p2 - p0
    Vec3d normal;
};

/// A bilinear patch in the world. It emits on the side of dP/du x dP/dv, or on the other.
struct EmittingPatch {
    Bilinear surface;
    bool flip = false;
    /// Corner normals on the emitting side, any length; they decide the side of each point.
    std::array<Vec3d, 4> normals{Vec3d(0), Vec3d(0), Vec3d(0),
                                 Vec3d(0)};  // zeros if there are none
};

/// A sphere, cylinder or disk of its own frame, placed in the world by an affine map (area and
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
    Vec3d normal;       // unit; on the side of Hit::normal, flip included
    double spread = 0;  // 1 / density, m^2; the area if sampling is uniform
};

SurfaceSample sample_surface(const EmittingTriangle& triangle, const Vec2d& u);
SurfaceSample sample_surface(const EmittingPatch& patch, const Vec2d& u);
SurfaceSample sample_surface(const EmittingQuadric<Sphere>& sphere, const Vec2d& u);
SurfaceSample sample_surface(const EmittingQuadric<Cylinder>& cylinder, const Vec2d& u);
SurfaceSample sample_surface(const EmittingQuadric<Disk>& disk, const Vec2d& u);
inline SurfaceSample sample_surface(const EmittingSurface& surface, const Vec2d& u) {
    return std::visit([&](const auto& s) { return sample_surface(s, u); }, surface);
}

/// Inverts sample_surface(): returns u for the surface point `on` with unit world normal `normal`
/// (either side).
Vec2d surface_square(const EmittingTriangle& triangle, const Vec3d& on, const Vec3d& normal);
Vec2d surface_square(const EmittingPatch& patch, const Vec3d& on, const Vec3d& normal);
Vec2d surface_square(const EmittingQuadric<Sphere>& sphere, const Vec3d& on, const Vec3d& normal);
Vec2d surface_square(const EmittingQuadric<Cylinder>& cylinder, const Vec3d& on,
                     const Vec3d& normal);
Vec2d surface_square(const EmittingQuadric<Disk>& disk, const Vec3d& on, const Vec3d& normal);
inline Vec2d surface_square(const EmittingSurface& surface, const Vec3d& on, const Vec3d& normal) {
    return std::visit([&](const auto& s) { return surface_square(s, on, normal); }, surface);
}

/// Returns SurfaceSample::spread at the surface point `on` with unit world normal `normal` (either
/// side).
double surface_spread(const EmittingTriangle& triangle, const Vec3d& on, const Vec3d& normal);
double surface_spread(const EmittingPatch& patch, const Vec3d& on, const Vec3d& normal);
double surface_spread(const EmittingQuadric<Sphere>& sphere, const Vec3d& on, const Vec3d& normal);
double surface_spread(const EmittingQuadric<Cylinder>& cylinder, const Vec3d& on,
                      const Vec3d& normal);
double surface_spread(const EmittingQuadric<Disk>& disk, const Vec3d& on, const Vec3d& normal);

/// Returns the area in the world, m^2.
double surface_area(const EmittingTriangle& triangle);
double surface_area(const EmittingPatch& patch);
template <class Quadric>
double surface_area(const EmittingQuadric<Quadric>& surface) {
    return surface.shape.area(Affine(surface.to_world));
}

/// Returns whether the normal of a sphere points inwards; false for all other surfaces.
template <class Surface>
bool is_flipped(const Surface&) {
    return false;
}
inline bool is_flipped(const EmittingQuadric<Sphere>& sphere) {
    return sphere.flip;
}

/// Returns how far along its normal a ray must start, so that rounding to float leaves its origin
/// on its side of the surface.
float surface_error(const EmittingTriangle& triangle, const SurfaceSample& on);
float surface_error(const EmittingPatch& patch, const SurfaceSample& on);
float surface_error(const EmittingQuadric<Sphere>& sphere, const SurfaceSample& on);
float surface_error(const EmittingQuadric<Cylinder>& cylinder, const SurfaceSample& on);
float surface_error(const EmittingQuadric<Disk>& disk, const SurfaceSample& on);

/// The cone of directions in which a point outside sees a full sphere.
struct VisibleCap {
    Vec3d axis;           // unit, towards the centre
    double distance = 0;  // to the centre
    double radius = 0;
    double versine = 0;  // 1 - cos of the cone's half angle
};

/// Returns nothing for partial spheres, for non-similarities, and for points inside or on the
/// sphere.
std::optional<VisibleCap> visible_cap(const EmittingQuadric<Sphere>& sphere, const Vec3d& point);
/// Returns how far it is from a point of the surface through what it encloses, if visible_cap() is
/// what direct samples know of it from outside; infinity for other directions and surfaces.
double way_within(const EmittingQuadric<Sphere>& sphere, const Vec3d& on, const Vec3d& direction);
template <class Surface>
double way_within(const Surface&, const Vec3d&, const Vec3d&) {
    return std::numeric_limits<double>::infinity();
}
template <class Surface>
std::optional<VisibleCap> visible_cap(const Surface&, const Vec3d&) {
    return {};
}

}  // namespace sunfleck::engine
