// Built shapes, groups and instances: the data of a geometry that is ready for tracing.
//
// A group is one Embree scene: the world or an object. In a group, Embree's geometry id k is the
// mesh that is shape k of the group's list. In the world, instances follow. One further id stands
// for all shapes that are intersected exactly.
#pragma once

#include "core/huge_pages.h"
#include "geometry/affine.h"
#include "geometry/bounds.h"
#include "geometry/embree.h"
#include "geometry/geometry_input.h"
#include "geometry/triangle.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// One shape in the frame of its group. The address of the input must not change.
class BuiltShape {
public:
    using Corners = std::array<std::uint32_t, 3>;

    BuiltShape() = default;
    /// @param counting  {0,1,2}, {3,4,5} and so on, at least as many as a mesh has triangles.
    BuiltShape(const PlacedShape& source, RTCDevice device, const std::vector<Corners>& counting);

    const Shape& shape() const { return source_->shape; }
    /// Returns the mesh, or null for a shape that is intersected exactly.
    const TriangleMesh* mesh() const { return std::get_if<TriangleMesh>(&source_->shape); }
    const Placement& placement() const { return placement_; }
    bool flip() const { return source_->flip; }
    /// Returns the alpha function, or null for an opaque surface.
    const Cover& cover() const { return source_->cover; }
    /// Returns whether the shape is a mesh without normals, uvs and tangents.
    bool is_plain() const { return is_plain_; }
    /// Returns whether the normals of a mesh's triangles point away from area_vector().
    bool is_turned() const { return is_turned_; }
    const Bounds& bounds() const { return bounds_; }
    /// Returns how many of its surfaces are intersected exactly.
    std::uint32_t exact_count() const;
    /// Returns the bounds of one exactly intersected surface; empty if it cannot be hit.
    Bounds bounds_of(std::uint32_t element) const;
    /// Returns whether no ray can hit the shape.
    bool is_empty() const { return bounds_.is_empty(); }
    /// Returns Embree's geometry of a mesh that is not empty.
    RTCGeometry geometry() const { return geometry_.get(); }
    const Corners& corners(std::uint32_t primitive) const { return mesh()->triangles[primitive]; }
    /// Returns a triangle in the group's frame, as Embree has it.
    Triangle triangle(std::uint32_t primitive) const {
        const float* v = corner_floats(primitive);
        return {{Vec3d(v[0], v[1], v[2]), Vec3d(v[3], v[4], v[5]), Vec3d(v[6], v[7], v[8])}};
    }

    /// Returns the nine floats that triangle() reads.
    const float* corner_floats(std::uint32_t primitive) const {
        return &vertices_[std::size_t{9} * primitive];
    }

private:
    void place_triangles();
    void build_mesh(RTCDevice device, const std::vector<Corners>& counting);

    const PlacedShape* source_ = nullptr;
    Placement placement_;
    Bounds bounds_;
    bool is_plain_ = false;
    bool is_turned_ = false;
    // Nine floats per triangle, because a hit needs all corners and one memory access is cheaper
    // than an index and three accesses. One more float at the end is read by Embree but not used.
    HugeVector<float> vertices_;
    embree::Geometry geometry_;
};

/// One surface that is intersected exactly.
struct ExactPrimitive {
    std::uint32_t shape = 0;    // index into ShapeGroup::built
    std::uint32_t element = 0;  // index in the shape: Hit::primitive
};

/// The shapes of one Embree scene. attach_shapes() fills the scene; then the address must not
/// change.
struct ShapeGroup {
    const std::vector<BuiltShape>* built = nullptr;
    std::vector<std::uint32_t> shapes;  // indices into `built`
    std::vector<ExactPrimitive> exact;  // exactly intersected surfaces, by primitive
    embree::Scene scene;
    Bounds bounds;

    /// Returns the shape, and its triangle or surface, that Embree's ids stand for.
    ExactPrimitive named(std::uint32_t geometry, std::uint32_t primitive) const {
        if (geometry < shapes.size()) return {shapes[geometry], primitive};
        return exact[primitive];
    }
};

/// A group under a matrix. The matrix is rounded to float first, as in Embree, so that both mean
/// the same surface.
struct BuiltInstance {
    const ShapeGroup* group = nullptr;
    Placement placement;
    Affine size_of_inverse;   // absolute values of the inverse
    Affine error_of_inverse;  // error bound of Embree's inverse, times the matrix
    embree::Geometry geometry;

    BuiltInstance(const Matrix& to_world, const ShapeGroup& what, RTCDevice device);
    /// Returns a box around the transformed box of the group.
    Bounds bounds() const;
    /// Returns how far Embree's ray in the group's frame may be from the exact one, along `normal`.
    /// @param local  a point in the group's frame; `world` is the same point in the world.
    double ray_uncertainty(const Vec3d& normal, const Vec3d& local, const Vec3d& world) const;
};

}  // namespace sunfleck::engine
