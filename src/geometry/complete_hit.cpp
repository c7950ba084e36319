// Hits on meshes by the triangle in double, on exact shapes by the shape itself.
#include "geometry/complete_hit.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// The surface at a point, in the frame of the group.
struct Patch {
    Vec3d position;
    Vec3d normal;  // unit vector
    Vec3d shading_normal;
    Vec3d tangent;
    Vec2 uv;
    Vec2 weights{0};
    double uncertainty = 0;  // along the normal, of the surface that Embree uses
};

template <class V>
V interpolate(const std::vector<V>& values, const BuiltShape::Corners& c, const Vec3d& weights) {
    return values[c[0]] * static_cast<float>(weights.x) +
           values[c[1]] * static_cast<float>(weights.y) +
           values[c[2]] * static_cast<float>(weights.z);
}

Vec3d unit_or(const Vec3d& v, const Vec3d& otherwise) {
    const double length2 = v.dot(v);
    const bool usable = length2 > 0 && std::isfinite(length2);
    return usable ? v * (1 / std::sqrt(length2)) : otherwise;
}

/// Returns dp/du of the linear map from uv to position; any edge if the uvs have no area.
Vec3d tangent_from_uvs(const Triangle& triangle, const std::array<Vec2, 3>& uv) {
    const Vec2d du(double{uv[0].x} - uv[2].x, double{uv[1].x} - uv[2].x);
    const Vec2d dv(double{uv[0].y} - uv[2].y, double{uv[1].y} - uv[2].y);
    const Vec3d dp02 = triangle.corner[0] - triangle.corner[2];
    const Vec3d dp12 = triangle.corner[1] - triangle.corner[2];
    const double determinant = du.x * dv.y - dv.x * du.y;
    const Vec3d tangent = (dp02 * dv.y - dp12 * dv.x) * (1 / determinant);
    const double length2 = tangent.dot(tangent);
    return length2 > 0 && std::isfinite(length2) ? tangent : -dp02;
}

void texture(const BuiltShape& shape, const BuiltShape::Corners& c, const Vec3d& weights,
             Patch& patch, const Triangle& triangle) {
    std::array<Vec2, 3> uv{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)};
    const TriangleMesh& mesh = *shape.mesh();
    if (!mesh.uvs.empty()) uv = {mesh.uvs[c[0]], mesh.uvs[c[1]], mesh.uvs[c[2]]};
    for (int i = 0; i < 2; ++i)
        patch.uv[i] =
            static_cast<float>(weights.x * uv[0][i] + weights.y * uv[1][i] + weights.z * uv[2][i]);
    if (!mesh.tangents.empty()) {
        const Vec3d given(interpolate(mesh.tangents, c, weights));
        patch.tangent = shape.placement().to_world.vector(given);
        const double length2 = patch.tangent.dot(patch.tangent);
        if (length2 > 0 && std::isfinite(length2)) return;
    }
    patch.tangent = tangent_from_uvs(triangle, uv);
}

Patch on_mesh(const Intersection& found, const Line& line) {
    const BuiltShape& shape = *found.shape;
    const BuiltShape::Corners& c = shape.corners(found.primitive);
    const Triangle triangle = shape.triangle(found.primitive);
    const TriangleEdges edges(triangle);
    const Vec3d weights = barycentrics(triangle, edges, line.origin, line.direction, found.weights);
    Patch patch;
    patch.position = triangle.point(weights);
    patch.weights = Vec2(static_cast<float>(weights.y), static_cast<float>(weights.z));
    const Vec3d area_vector = edges.area_vector();
    const double per_area = 1 / std::sqrt(area_vector.dot(area_vector));
    patch.normal = area_vector * per_area;
    patch.uncertainty = kFloatRounding * per_area *
                        scaled_plane_uncertainty(triangle, edges, area_vector, patch.position);
    if (shape.is_turned()) patch.normal = -patch.normal;
    patch.shading_normal = patch.normal;
    if (!shape.mesh()->normals.empty()) {
        const Vec3d given(interpolate(shape.mesh()->normals, c, weights));
        const Vec3d smooth = shape.placement().normal(shape.flip() ? -given : given);
        patch.shading_normal = unit_or(smooth, patch.normal);
        if (patch.normal.dot(patch.shading_normal) < 0) patch.normal = -patch.normal;
    }
    texture(shape, c, weights, patch, triangle);
    return patch;
}

/// Returns the rounding error in double of a point that went through a map and its inverse.
double double_uncertainty(const Vec3d& position, const Affine& map) {
    const Vec3d from_origin = position - map.origin;
    const double size = std::abs(position.x) + std::abs(position.y) + std::abs(position.z) +
                        std::abs(from_origin.x) + std::abs(from_origin.y) + std::abs(from_origin.z);
    return 0x1p-42 * size;
}

/// Returns the factor by which a map changes the distance of planes. @param image  of their unit
/// normal.
double stretch_across(const Placement& placement, const Vec3d& image) {
    return std::abs(placement.to_world.determinant()) / std::sqrt(image.dot(image));
}

Patch on_exact_shape(const Intersection& found, const Line& line) {
    const Placement& placement = found.shape->placement();
    const Line local = line.through(placement.to_object);
    const Vec3d near = local.origin + local.direction * found.t;
    const auto around = [&](const auto& one) { return one.at(near, local.direction); };
    const LocalSurface surface = std::visit(
        [&](const auto& s) { return with_exact(s, found.primitive, around, LocalSurface()); },
        found.shape->shape());
    Patch patch;
    patch.position = placement.to_world.point(surface.position);
    patch.normal = unit_or(placement.normal(surface.normal), {0, 0, 1});
    if (found.shape->flip()) patch.normal = -patch.normal;
    patch.shading_normal = patch.normal;
    const Vec3d given = placement.normal(surface.given_normal);
    if (given != Vec3d(0)) {
        patch.shading_normal = unit_or(found.shape->flip() ? -given : given, patch.normal);
        if (patch.normal.dot(patch.shading_normal) < 0) patch.normal = -patch.normal;
    }
    patch.uncertainty = double_uncertainty(patch.position, placement.to_world);
    if (surface.clearance > 0)
        patch.uncertainty +=
            surface.clearance * stretch_across(placement, placement.normal(surface.normal));
    patch.tangent = placement.to_world.vector(surface.tangent);
    patch.uv = surface.uv;
    return patch;
}

/// Transforms the patch from the instance's frame to the world.
void leave_instance(const BuiltInstance& instance, bool is_mesh, Patch& patch) {
    const Placement& placement = instance.placement;
    const Vec3d local = patch.position;
    patch.position = placement.to_world.point(local);
    const Vec3d normal = placement.normal(patch.normal);
    if (is_mesh) patch.uncertainty += instance.ray_uncertainty(patch.normal, local, patch.position);
    patch.uncertainty *= stretch_across(placement, normal);
    patch.normal = unit_or(normal, {0, 0, 1});
    patch.shading_normal = unit_or(placement.normal(patch.shading_normal), patch.normal);
    patch.tangent = placement.to_world.vector(patch.tangent);
    patch.uncertainty += double_uncertainty(patch.position, placement.to_world);
}

float error_bound(double uncertainty) {
    return std::max(static_cast<float>(uncertainty * 1.1), 1e-30F);
}

float distance_along(const Line& line, const Vec3d& position) {
    const double way = (position - line.origin).dot(line.direction);
    return static_cast<float>(way / line.direction.dot(line.direction));
}

/// Completes the most frequent hits: on a world mesh that has positions alone. The result equals
/// that of a Patch to the last bits, with one square root and three divisions.
void complete_plain(const Intersection& found, const Line& line, Hit& hit) {
    const BuiltShape& shape = *found.shape;
    const Triangle triangle = shape.triangle(found.primitive);
    const TriangleEdges edges(triangle);
    const Vec3d weights = barycentrics(triangle, edges, line.origin, line.direction, found.weights);
    const Vec3d position = triangle.point(weights);
    const Vec3d area_vector = edges.area_vector();
    const double per_area = 1 / std::sqrt(area_vector.dot(area_vector));
    const double scaled = scaled_plane_uncertainty(triangle, edges, area_vector, position) +
                          kStoringRoundings * absolute_dot(area_vector, position);
    hit.position = Vec3(position);
    hit.normal = Vec3(area_vector * (shape.is_turned() ? -per_area : per_area));
    hit.shading_normal = hit.normal;
    hit.tangent = Vec3(edges.first);
    hit.uv = Vec2(static_cast<float>(weights.y + weights.z), static_cast<float>(weights.z));
    hit.weights = Vec2(static_cast<float>(weights.y), static_cast<float>(weights.z));
    hit.error = error_bound(kFloatRounding * per_area * scaled);
    hit.distance = distance_along(line, position);
    hit.primitive = found.primitive;
}

}  // namespace

void complete_hit(const Intersection& found, const Line& line, Hit& hit) {
    const BuiltInstance* instance = found.instance;
    if (instance == nullptr && found.shape->is_plain()) return complete_plain(found, line, hit);
    const bool is_mesh = found.shape->mesh() != nullptr;
    const Line local = instance == nullptr ? line : line.through(instance->placement.to_object);
    Patch patch = is_mesh ? on_mesh(found, local) : on_exact_shape(found, local);
    if (instance != nullptr) leave_instance(*instance, is_mesh, patch);

    hit.position = Vec3(patch.position);
    hit.normal = Vec3(patch.normal);
    hit.shading_normal = Vec3(patch.shading_normal);
    if (!(hit.normal.dot(hit.shading_normal) > 0)) hit.shading_normal = hit.normal;
    hit.tangent = Vec3(patch.tangent);
    hit.uv = patch.uv;
    hit.weights = patch.weights;
    hit.error = error_bound(patch.uncertainty + rounding_uncertainty(patch.normal, patch.position));
    hit.distance = distance_along(line, patch.position);
    hit.primitive = found.primitive;
}

}  // namespace sunfleck::engine
