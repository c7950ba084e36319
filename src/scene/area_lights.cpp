// An emitting shape becomes area lights: one a triangle, one a patch, one a quadric.
#include "scene/area_lights.h"

#include "geometry/measure.h"
#include "light/partial_emitter.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// The side of the triangle that rays will call outside: by its winding in the object's frame,
/// turned to agree with vertex normals, turned again by ReverseOrientation (pbrt-v4).
/// @param cross  of the edges in the world.
Vec3d outside(const TriangleMesh& mesh, std::size_t triangle, const PlacedShape& placed,
              const Vec3d& cross) {
    double side = placed.flip ? -1 : 1;
    const Placement placement(placed.to_world);
    if (placement.mirrors) side = -side;
    if (!mesh.normals.empty()) {
        Vec3d sum(0);
        for (const std::uint32_t corner : mesh.triangles[triangle])
            sum += Vec3d(mesh.normals[corner]);
        const double agreement = placement.normal(sum).dot(cross);
        if (agreement != 0) side = (agreement > 0) != placed.flip ? 1 : -1;
    }
    return cross * (side / cross.length());
}

EmittingTriangle emitting_triangle(const TriangleMesh& mesh, std::size_t triangle,
                                   const PlacedShape& placed) {
    const auto [corner] = placed_triangle(mesh, Affine(placed.to_world), triangle);
    EmittingTriangle result{corner[0], corner[1] - corner[0], corner[2] - corner[0], Vec3d(0)};
    const Vec3d cross = result.edge1.cross(result.edge2);
    if (cross.length2() > 0) result.normal = outside(mesh, triangle, placed, cross);
    return result;
}

/// As hits have them: pbrt-v4's where the mesh gives none.
CornerUvs corner_uvs(const TriangleMesh& mesh, std::size_t triangle) {
    CornerUvs uvs{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)};
    if (mesh.uvs.empty()) return uvs;
    const auto& corners = mesh.triangles[triangle];
    for (std::size_t i = 0; i < 3; ++i)
        if (corners.at(i) < mesh.uvs.size()) uvs.at(i) = mesh.uvs[corners.at(i)];
    return uvs;
}

EmittingPatch emitting_patch(const BilinearMesh& mesh, std::uint32_t index,
                             const PlacedShape& placed) {
    const Placement placement(placed.to_world);
    const BilinearPatch patch = mesh.element(index);
    EmittingPatch result{patch.surface.image(placement.to_world), placed.flip != placement.mirrors};
    for (std::size_t i = 0; i < 4; ++i)
        result.normals.at(i) = placement.normal(patch.normals.at(i)) * (placed.flip ? -1 : 1);
    return result;
}

/// pbrt-v4's "power" is that of each light, and each triangle of a mesh is one.
Spectrum radiance_of(const AreaEmission& emission, double area) {
    if (!(emission.power > 0) || !(area > 0)) return emission.radiance;
    const double sides = emission.two_sided ? 2 : 1;
    const double mean = emission.picture ? emission.picture->mean() : 1;
    if (!(mean > 0)) return emission.radiance;
    return emission.radiance.scaled(
        static_cast<float>(emission.power / (kPiDouble * area * sides * mean)));
}

/// All tables of pictures on one shape together have so many cells (12 bytes each), or one a light.
constexpr int kMostCells = 1 << 22;

}  // namespace

std::vector<AreaLight> area_lights_of(const ShapeDescription& shape, std::uint32_t index) {
    const AreaEmission& emission = *shape.emission;
    const PlacedShape& placed = shape.placed;
    std::vector<AreaLight> lights;
    int cells = kMostCells;
    const auto add = [&](auto surface, double area, const CornerUvs& uvs = {}) {
        lights.push_back({radiance_of(emission, area), std::move(surface), emission.two_sided,
                          index, static_cast<std::uint32_t>(lights.size()), shape.unseen});
        AreaLight& light = lights.back();
        if (emission.picture && area > 0)
            light.picture =
                std::make_shared<const LaidPicture>(emission.picture, uvs, light.surface, cells);
        if (placed.cover)
            light.alpha = std::make_shared<const PartialEmitter>(placed.cover, uvs, light.surface);
    };
    if (const auto* mesh = std::get_if<TriangleMesh>(&placed.shape)) {
        cells /= static_cast<int>(std::clamp<std::size_t>(mesh->triangles.size(), 1, kMostCells));
        for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
            const EmittingTriangle triangle = emitting_triangle(*mesh, t, placed);
            add(triangle, 0.5 * triangle.edge1.cross(triangle.edge2).length(),
                corner_uvs(*mesh, t));
        }
    } else if (const auto* patches = std::get_if<BilinearMesh>(&placed.shape)) {
        cells /= static_cast<int>(std::clamp<std::uint32_t>(patches->count(), 1, kMostCells));
        for (std::uint32_t p = 0; p < patches->count(); ++p) {
            const EmittingPatch patch = emitting_patch(*patches, p, placed);
            add(patch, patch.surface.area(), patches->element(p).uvs);
        }
    } else if (const auto* cylinder = std::get_if<Cylinder>(&placed.shape)) {
        add(EmittingQuadric<Cylinder>{*cylinder, placed.to_world, placed.flip},
            surface_area(placed));
    } else if (const auto* sphere = std::get_if<Sphere>(&placed.shape)) {
        add(EmittingQuadric<Sphere>{*sphere, placed.to_world, placed.flip}, surface_area(placed));
    } else if (const auto* disk = std::get_if<Disk>(&placed.shape)) {
        add(EmittingQuadric<Disk>{*disk, placed.to_world, placed.flip}, surface_area(placed));
    }
    return lights;
}

}  // namespace sunfleck::engine
