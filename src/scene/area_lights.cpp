// Conversion of an emitting shape to area lights: one per triangle, patch or quadric.
#include "scene/area_lights.h"

#include "geometry/extent.h"
#include "geometry/measure.h"
#include "light/partial_emitter.h"
#include "math/finite_product.h"

#include <algorithm>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Returns the normal of the side that rays call outside: by the winding in the object's frame,
/// flipped to agree with vertex normals, flipped again by ReverseOrientation (pbrt-v4).
/// @param cross  cross product of the edges in the world.
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

/// @param at  the triangle in the world.
EmittingTriangle emitting_triangle(const TriangleMesh& mesh, std::size_t triangle,
                                   const PlacedShape& placed, const Triangle& at) {
    const auto& corner = at.corner;
    EmittingTriangle result{corner[0], corner[1] - corner[0], corner[2] - corner[0], Vec3d(0)};
    const Vec3d cross = result.edge1.cross(result.edge2);
    if (cross.length2() > 0) result.normal = outside(mesh, triangle, placed, cross);
    return result;
}

/// Returns the coordinates that hits have: pbrt-v4's if the mesh gives none.
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

/// pbrt-v4's "power" applies to each light, and each triangle of a mesh is a light.
/// @throws Error  at the shape, for a radiance that is no finite float.
Spectrum radiance_of(const AreaEmission& emission, double area, const SourceLocation& shape) {
    if (!(emission.power > 0) || !(area > 0)) return emission.radiance;
    const double sides = emission.two_sided ? 2 : 1;
    const double mean = emission.image ? emission.image->mean() : 1;
    const double peak = emission.image ? emission.image->peak() : 1;
    if (!(mean > 0)) return emission.radiance;
    const double factor = emission.power / (kPiDouble * area * sides * mean);
    if (auto radiance = finite_product(emission.radiance, factor, peak))
        return *std::move(radiance);
    throw Error(shape,
                "the area light of this shape is too bright: its radiance times \"power\" over "
                "the area is no finite float",
                "keep it below 3.4e38: reduce \"power\", or enlarge the shape");
}

/// Limit of cells for the image tables of one shape together (12 bytes per cell), at least one cell
/// per light.
constexpr int kMostCells = 1 << 22;

/// Makes the lights of a shape: one overload for each kind.
class LightsOfShape {
public:
    LightsOfShape(const ShapeDescription& shape, std::uint32_t index)
        : shape_(shape), emission_(*shape.emission), index_(index) {}

    std::vector<AreaLight> take() { return std::move(lights_); }

    void operator()(const TriangleMesh& mesh) {
        cells_ /= static_cast<int>(std::clamp<std::size_t>(mesh.triangles.size(), 1, kMostCells));
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const Triangle at = placed_triangle(mesh, Affine(shape_.placed.to_world), t);
            const EmittingTriangle triangle = emitting_triangle(mesh, t, shape_.placed, at);
            const double area = 0.5 * triangle.edge1.cross(triangle.edge2).length();
            add({triangle, area, is_in_range(at), corner_uvs(mesh, t)});
        }
    }
    void operator()(const BilinearMesh& patches) {
        cells_ /= static_cast<int>(std::clamp<std::uint32_t>(patches.count(), 1, kMostCells));
        for (std::uint32_t p = 0; p < patches.count(); ++p) {
            const EmittingPatch patch = emitting_patch(patches, p, shape_.placed);
            add({patch, patch.surface.area(), is_in_range(patch.surface.bounds()),
                 patches.element(p).uvs});
        }
    }
    void operator()(const Sphere& sphere) { add_quadric(sphere); }
    void operator()(const Disk& disk) { add_quadric(disk); }
    void operator()(const Cylinder& cylinder) { add_quadric(cylinder); }
    void operator()(const Curves&) {}  // emit no light: the importer says so

private:
    template <class Quadric>
    void add_quadric(const Quadric& quadric) {
        const PlacedShape& placed = shape_.placed;
        add({EmittingQuadric<Quadric>{quadric, placed.to_world, placed.flip},
             surface_area(placed),
             is_in_range(quadric.bounds(Affine(placed.to_world))),
             {}});
    }

    /// One triangle, patch or quadric.
    struct Element {
        EmittingSurface surface;
        double area = 0;
        bool in_range = true;  // else Geometry leaves it out, and it is black here
        CornerUvs uvs{};
    };

    void add(const Element& element) {
        const auto& [surface, area, in_range, uvs] = element;
        lights_.push_back({in_range ? radiance_of(emission_, area, shape_.where) : Spectrum(),
                           surface, emission_.two_sided, index_,
                           static_cast<std::uint32_t>(lights_.size()), shape_.unseen});
        if (!in_range) return;
        AreaLight& light = lights_.back();
        if (emission_.image && area > 0)
            light.image =
                std::make_shared<const PlacedImage>(emission_.image, uvs, light.surface, cells_);
        if (const Cover& cover = shape_.placed.cover)
            light.alpha = std::make_shared<const PartialEmitter>(cover, uvs, light.surface);
    }

    const ShapeDescription& shape_;
    const AreaEmission& emission_;
    std::uint32_t index_;
    int cells_ = kMostCells;  // of an image's table, for each light
    std::vector<AreaLight> lights_;
};

}  // namespace

std::vector<AreaLight> area_lights_of(const ShapeDescription& shape, std::uint32_t index) {
    LightsOfShape lights(shape, index);
    std::visit(lights, shape.placed.shape);
    return lights.take();
}

}  // namespace sunfleck::engine
