// Construction: vertices in the group's frame, surfaces that cannot be hit, groups and instances.
#include "geometry/built.h"

#include "geometry/extent.h"
#include "geometry/measure.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace sunfleck::engine {
namespace {

Matrix rounded_to_float(const Matrix& m) {
    Matrix result;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) result[i][j] = static_cast<float>(m[i][j]);
    return result;
}

Vec3d absolute(const Vec3d& v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

/// Returns the components of a cross product with every term taken as positive.
Vec3d absolute_cross(const Vec3d& a, const Vec3d& b) {
    return {std::abs(a.y * b.z) + std::abs(a.z * b.y), std::abs(a.z * b.x) + std::abs(a.x * b.z),
            std::abs(a.x * b.y) + std::abs(a.y * b.x)};
}

Affine absolute(const Affine& map) {
    Affine result;
    result.x = absolute(map.x);
    result.y = absolute(map.y);
    result.z = absolute(map.z);
    result.origin = absolute(map.origin);
    return result;
}

/// Returns the error of Embree's inverse times the matrix. Embree inverts by cofactors in float:
/// each is off by three roundings of its terms, and the determinant by as much.
Affine inverse_error(const Affine& map, const Affine& inverse) {
    const double volume = std::abs(map.determinant());
    const std::array<Vec3d, 3> rows{absolute_cross(map.y, map.z) / volume,
                                    absolute_cross(map.z, map.x) / volume,
                                    absolute_cross(map.x, map.y) / volume};
    const double spread = absolute_dot(map.x, rows[0]);
    const Affine size = absolute(inverse);
    const auto column = [&](int i, const Vec3d& entry) {
        return Vec3d(rows[0][i], rows[1][i], rows[2][i]) * 3 + entry * (4 * spread + 1);
    };
    Affine error;
    error.x = column(0, size.x);
    error.y = column(1, size.y);
    error.z = column(2, size.z);
    const Affine matrix = absolute(map);
    Affine product;
    product.x = error.vector(matrix.x);
    product.y = error.vector(matrix.y);
    product.z = error.vector(matrix.z);
    return product;
}

}  // namespace

BuiltShape::BuiltShape(const PlacedShape& source, RTCDevice device,
                       const std::vector<Corners>& counting)
    : source_(&source), placement_(source.to_world), is_turned_(flip() != placement_.mirrors) {
    if (mesh() != nullptr) {
        is_plain_ = mesh()->normals.empty() && mesh()->uvs.empty() && mesh()->tangents.empty();
        build_mesh(device, counting);
        return;
    }
    if (!placement_.is_invertible) return;
    const std::uint32_t count = exact_count();
    for (std::uint32_t i = 0; i < count; ++i) bounds_.extend(bounds_of(i));
}

std::uint32_t BuiltShape::exact_count() const {
    return std::visit([](const auto& s) { return sunfleck::engine::exact_count(s); }, shape());
}

Bounds BuiltShape::bounds_of(std::uint32_t element) const {
    const auto box_of = [&](const auto& surface) { return surface.bounds(placement_.to_world); };
    const Bounds box = std::visit(
        [&](const auto& s) { return with_exact(s, element, box_of, Bounds()); }, shape());
    return is_in_range(box) ? box : Bounds();
}

/// A triangle that cannot be hit keeps its index, but its corners are NaN: Embree ignores it.
void BuiltShape::place_triangles() {
    const TriangleMesh& source = *mesh();
    vertices_.reserve(9 * source.triangles.size() + 1);
    for (std::size_t i = 0; i < source.triangles.size(); ++i) {
        const Corners& c = source.triangles[i];
        const bool exists = *std::max_element(c.begin(), c.end()) < source.positions.size();
        const Triangle t = exists ? placed_triangle(source, placement_.to_world, i)
                                  : Triangle{{Vec3d(0), Vec3d(0), Vec3d(0)}};
        const bool is_there = is_in_range(t) && t.has_area();
        for (const Vec3d& p : t.corner) {
            if (is_there) bounds_.extend(p);
            for (int axis = 0; axis < 3; ++axis)
                vertices_.push_back(is_there ? static_cast<float>(p[axis]) : std::nanf(""));
        }
    }
    vertices_.push_back(0);
}

void BuiltShape::build_mesh(RTCDevice device, const std::vector<Corners>& counting) {
    place_triangles();
    if (is_empty()) return;
    const std::size_t count = mesh()->triangles.size();
    geometry_ = embree::new_geometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    RTCGeometry g = geometry_.get();
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertices_.data(), 0,
                               3 * sizeof(float), 3 * count);
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, counting.data(), 0,
                               sizeof(Corners), count);
    rtcCommitGeometry(g);
    embree::check(device);
}

BuiltInstance::BuiltInstance(const Matrix& to_world, const ShapeGroup& what, RTCDevice device)
    : group(&what), placement(rounded_to_float(to_world)) {
    if (!placement.is_invertible || what.bounds.is_empty()) return;
    const double size = absolute_dot(placement.to_world.origin, Vec3d(1));
    if (!(size < kLargestExtent)) return;
    size_of_inverse = absolute(placement.to_object);
    error_of_inverse = inverse_error(placement.to_world, placement.to_object);
    std::vector<float> columns;
    const Affine& map = placement.to_world;
    for (const Vec3d& column : {map.x, map.y, map.z, map.origin})
        for (int i = 0; i < 3; ++i) columns.push_back(static_cast<float>(column[i]));
    geometry = embree::new_geometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry.get(), what.scene.get());
    rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
    rtcCommitGeometry(geometry.get());
}

Bounds BuiltInstance::bounds() const {
    return image_of(group->bounds, placement.to_world);
}

/// Embree's inverse maps the world point as W p - W t: three products and four sums, each rounded.
double BuiltInstance::ray_uncertainty(const Vec3d& normal, const Vec3d& local,
                                      const Vec3d& world) const {
    const Vec3d far = absolute(world) + absolute(placement.to_world.origin);
    const Vec3d moved = size_of_inverse.vector(far) * 5 + error_of_inverse.vector(absolute(local));
    return kFloatRounding * absolute_dot(normal, moved);
}

}  // namespace sunfleck::engine
