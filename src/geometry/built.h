// What a geometry is built into: shapes ready to be traced, groups of them, instances of groups.
//
// A group is one Embree scene: the world, or an object. In a group, Embree's geometry number k is
// the mesh that is shape k of the group's list; in the world's, instances follow; one number more
// holds all shapes that are intersected exactly.
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

/// One shape in the frame of its group. The input must stay where it is.
class BuiltShape {
public:
    using Corners = std::array<std::uint32_t, 3>;

    BuiltShape() = default;
    /// @param counting  {0,1,2}, {3,4,5} and so on, at least as many as a mesh has triangles.
    BuiltShape(const PlacedShape& source, RTCDevice device, const std::vector<Corners>& counting);

    const Shape& shape() const { return source_->shape; }
    /// Null for shapes that are intersected exactly.
    const TriangleMesh* mesh() const { return std::get_if<TriangleMesh>(&source_->shape); }
    const Placement& placement() const { return placement_; }
    bool flip() const { return source_->flip; }
    /// Null where all of the surface is there.
    const Cover& cover() const { return source_->cover; }
    /// Is it a mesh with neither normals nor uvs nor tangents?
    bool is_plain() const { return is_plain_; }
    /// Do the normals of a mesh's triangles point away from the side of area_vector()?
    bool is_turned() const { return is_turned_; }
    const Bounds& bounds() const { return bounds_; }
    /// How many surfaces of it are intersected exactly.
    std::uint32_t exact_count() const;
    /// Of one surface of a shape that is intersected exactly; empty if it cannot be hit.
    Bounds bounds_of(std::uint32_t element) const;
    /// Is there nothing to hit?
    bool is_empty() const { return bounds_.is_empty(); }
    /// Of a mesh that is not empty.
    RTCGeometry geometry() const { return geometry_.get(); }
    const Corners& corners(std::uint32_t primitive) const { return mesh()->triangles[primitive]; }
    /// In the frame of the group, as Embree has it.
    Triangle triangle(std::uint32_t primitive) const {
        const float* v = corner_floats(primitive);
        return {{Vec3d(v[0], v[1], v[2]), Vec3d(v[3], v[4], v[5]), Vec3d(v[6], v[7], v[8])}};
    }

    /// Nine floats of a mesh: what triangle() reads.
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
    // Nine floats a triangle: a hit needs its corners, and one look at memory costs less than an
    // index and three looks. At the end one float that Embree reads but does not use.
    HugeVector<float> vertices_;
    embree::Geometry geometry_;
};

/// One surface that is intersected exactly.
struct ExactPrimitive {
    std::uint32_t shape = 0;    // index into ShapeGroup::built
    std::uint32_t element = 0;  // of the shape: what Hit::primitive says
};

/// Shapes that one Embree scene holds; attach_shapes() fills it, and then it must stay where it is.
struct ShapeGroup {
    const std::vector<BuiltShape>* built = nullptr;
    std::vector<std::uint32_t> shapes;  // indices into `built`
    std::vector<ExactPrimitive> exact;  // surfaces that are intersected exactly, by primitive
    embree::Scene scene;
    Bounds bounds;

    /// The shape that Embree's numbers name, and which triangle or surface of it.
    ExactPrimitive named(std::uint32_t geometry, std::uint32_t primitive) const {
        if (geometry < shapes.size()) return {shapes[geometry], primitive};
        return exact[primitive];
    }
};

/// A group under a matrix. The matrix is rounded to float first, as Embree does: then both mean
/// the same surface.
struct BuiltInstance {
    const ShapeGroup* group = nullptr;
    Placement placement;
    Affine size_of_inverse;   // absolute values
    Affine error_of_inverse;  // bound of what Embree's inverse, times the matrix, may be off
    embree::Geometry geometry;

    BuiltInstance(const Matrix& to_world, const ShapeGroup& what, RTCDevice device);
    /// Box around the turned box of the group.
    Bounds bounds() const;
    /// How far, along `normal`, Embree's ray in the group's frame may be from the true one.
    /// @param local  a point in the group's frame; `world` the same in the world.
    double ray_uncertainty(const Vec3d& normal, const Vec3d& local, const Vec3d& world) const;
};

}  // namespace sunfleck::engine
