// Primitives become shapes.
#include "import/gltf/shapes.h"

#include "math/trigonometry.h"
#include "scene/absorption.h"

#include <algorithm>
#include <string>
#include <utility>

namespace sunfleck::engine {

namespace {

constexpr Vec3 kNoDirection(0, 0, 0);

/// Returns directions of the surface at the vertices, at an angle to that in which u grows.
/// @param turn  radians, towards the direction in which v grows.
std::vector<Vec3> turned_tangents(const TriangleMesh& mesh, double turn) {
    const SinCos at = sin_cos_2pi(turn / (2 * kPiDouble));
    std::vector<Vec3> tangents(mesh.positions.size(), kNoDirection);
    for (const auto& c : mesh.triangles) {
        const Vec2d u1(mesh.uvs[c[1]] - mesh.uvs[c[0]]);
        const Vec2d u2(mesh.uvs[c[2]] - mesh.uvs[c[0]]);
        const Vec3d p1(mesh.positions[c[1]] - mesh.positions[c[0]]);
        const Vec3d p2(mesh.positions[c[2]] - mesh.positions[c[0]]);
        const double side = u1.x * u2.y - u2.x * u1.y < 0 ? -1 : 1;
        const Vec3d along_u = ((p1 * u2.y - p2 * u1.y) * side).normalized();
        const Vec3d along_v = ((p2 * u1.x - p1 * u2.x) * side).normalized();
        const Vec3 tangent(along_u * at.cos + along_v * at.sin);
        for (const std::uint32_t corner : c) tangents[corner] += tangent;
    }
    return tangents;
}

}  // namespace

GltfShapes::GltfShapes(GltfDocument& document, const Accessors& accessors, const GltfNodes& nodes,
                       SceneDescription& scene, const ImportSettings& settings)
    : document_(document),
      accessors_(accessors),
      nodes_(nodes),
      scene_(scene),
      rule_(settings.glass),
      materials_(document, scene, settings) {}

std::vector<GltfShapes::Part> GltfShapes::parts_of(const GltfNode& node, const JsonPlace& mesh) {
    const MeshPose pose = pose_of(document_, nodes_, accessors_, node, mesh);
    std::vector<Part> parts;
    for (const JsonPlace& primitive : mesh.at("primitives").elements()) {
        const std::vector<std::uint64_t> uv_sets = materials_.uv_sets_of(primitive);
        auto triangles =
            triangles_of(accessors_, primitive, pose, uv_sets.front(), scene_.warnings);
        if (!triangles) continue;
        const GltfLook& look = materials_.look_of(
            primitive, vertices_of(document_, accessors_, primitive, uv_sets, *triangles));
        if (look.tangent_turn != 0 && !triangles->uvs.empty())
            triangles->tangents = turned_tangents(*triangles, look.tangent_turn);
        parts.push_back({std::move(*triangles), &look, primitive.where()});
    }
    return parts;
}

std::vector<ShapeDescription> GltfShapes::of(const GltfNode& node, const JsonPlace& mesh) {
    std::vector<Part> parts = parts_of(node, mesh);
    const bool has_glass = std::any_of(parts.begin(), parts.end(),
                                       [](const Part& p) { return p.look->glass.has_value(); });
    std::vector<SurfaceSides> sides;
    if (has_glass) {
        std::vector<const TriangleMesh*> meshes;
        for (const Part& part : parts) meshes.push_back(&part.mesh);
        sides = sides_of_primitives(meshes);
    }
    std::vector<ShapeDescription> shapes;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].look->glass)
            add_glass(parts[i], sides[i], shapes);
        else
            shapes.push_back(shape_of(parts[i], std::move(parts[i].mesh)));
    return shapes;
}

ShapeDescription GltfShapes::shape_of(const Part& part, TriangleMesh mesh) {
    ShapeDescription shape;
    shape.placed.shape = std::move(mesh);
    shape.placed.cover = part.look->cover;
    shape.material = part.look->material;
    shape.emission = part.look->emission;
    shape.alpha = part.look->alpha;
    shape.where = part.where;
    return shape;
}

void GltfShapes::add_glass(Part& part, const SurfaceSides& sides,
                           std::vector<ShapeDescription>& shapes) {
    const std::vector<bool>& closed = sides.is_closed;
    const bool all_closed = std::all_of(closed.begin(), closed.end(), [](bool c) { return c; });
    std::vector<bool> solid = closed;
    if (rule_ != GlassRule::automatic) solid.assign(closed.size(), rule_ == GlassRule::solid);
    // Alpha cuts holes. Values of vertices are looked up by the number of a triangle: such a part
    // stays whole.
    const bool stays_whole = part.look->is_of_vertices && !all_closed;
    if (rule_ == GlassRule::automatic && (stays_whole || part.look->cover))
        solid.assign(closed.size(), false);
    std::vector<bool> thin = solid;
    thin.flip();
    if (!part.look->is_of_vertices) turn_triangles(part.mesh, sides.is_reversed);
    TriangleMesh inside = chosen_triangles(part.mesh, solid);
    TriangleMesh panes = chosen_triangles(part.mesh, thin);
    if (!panes.triangles.empty()) shapes.push_back(pane_of(part, std::move(panes)));
    if (!inside.triangles.empty())
        shapes.push_back(
            solid_of(part, std::move(inside), all_closed || rule_ == GlassRule::automatic));
}

ShapeDescription GltfShapes::pane_of(const Part& part, TriangleMesh mesh) {
    ++thin_glass_;
    if (part.look->glass->is_rough)
        scene_.warnings.add(part.where, "thin glass is smooth: its roughness is left out");
    if (part.look->glass->volume.scattering != Vec3d(0))
        scene_.warnings.add(part.where,
                            "thin glass has no inside: its volume that scatters is left out");
    ShapeDescription shape = shape_of(part, std::move(mesh));
    shape.material = part.look->glass->pane;
    return shape;
}

/// A straight way through solid glass of mean length has its colour.
ShapeDescription GltfShapes::solid_of(const Part& part, TriangleMesh mesh, bool is_closed) {
    ++solid_glass_;
    const GltfLook::Glass& glass = *part.look->glass;
    GltfVolume volume = glass.volume;
    const double chord = is_closed ? mean_chord_of(mesh.positions, mesh.triangles) : 0;
    if (chord > 0) volume.absorption += absorption_over(chord, glass.colour);
    if (chord > 0 && glass.has_texture)
        scene_.warnings.add(part.where,
                            "a texture of solid glass is left out: its factor alone colours it");
    ShapeDescription shape = shape_of(part, std::move(mesh));
    if (volume.absorption != Vec3d(0) || volume.scattering != Vec3d(0))
        shape.media.inside = add_medium(scene_, volume);
    return shape;
}

void GltfShapes::tell_glass() const {
    if (rule_ != GlassRule::automatic || solid_glass_ + thin_glass_ == 0) return;
    const auto parts = [](std::size_t count) {
        return std::to_string(count) + (count == 1 ? " part" : " parts");
    };
    std::string text = "glass: ";
    if (solid_glass_ > 0) text += parts(solid_glass_) + " closed, so solid";
    if (solid_glass_ > 0 && thin_glass_ > 0) text += "; ";
    if (thin_glass_ > 0) text += parts(thin_glass_) + " open, so thin panes";
    scene_.warnings.add({scene_.path}, text + " (--glass solid|thin for all)");
}

}  // namespace sunfleck::engine
