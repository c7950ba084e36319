// Bilinear patches that share vertices.
#pragma once

#include "geometry/bilinear.h"

#include <vector>

namespace sunfleck::engine {

/// One patch with what its corners bring along. The normal is dP/du x dP/dv, or on the side of the
/// corners' normals.
struct BilinearPatch {
    Bilinear surface;
    std::array<Vec3d, 4> normals{Vec3d(0), Vec3d(0), Vec3d(0), Vec3d(0)};  // zeros: none
    std::array<Vec2, 4> uvs{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)};
    bool has_uvs = false;

    Crossings crossings(const Vec3d& origin, const Vec3d& direction) const {
        return surface.meet(origin, direction).line;
    }
    LocalSurface at(const Vec3d& near, const Vec3d& direction) const;
    /// Of the corners: tight.
    Bounds bounds(const Affine& map) const { return surface.image(map).bounds(); }
};

/// The corners of a patch are given in the order P(0,0), P(1,0), P(0,1), P(1,1) (pbrt-v4).
struct BilinearMesh {
    std::vector<Vec3> positions;
    std::vector<std::array<std::uint32_t, 4>> patches;
    std::vector<Vec3> normals;  // one a vertex, or empty
    std::vector<Vec2> uvs;      // one a vertex, or empty

    std::uint32_t count() const { return static_cast<std::uint32_t>(patches.size()); }
    /// Patches with a vertex that is not in the list have corners that are not numbers.
    BilinearPatch element(std::uint32_t patch) const;
    /// Of all patches.
    double area(const Affine& map) const;
};

static_assert(ExactShapes<BilinearMesh> && HasArea<BilinearMesh>);

}  // namespace sunfleck::engine
