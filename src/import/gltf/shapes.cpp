// Primitives become shapes.
#include "import/gltf/shapes.h"

#include "import/gltf/glass.h"

#include <algorithm>
#include <utility>

namespace sunfleck::engine {

GltfShapes::GltfShapes(GltfDocument& document, const Accessors& accessors, const GltfNodes& nodes,
                       SceneDescription& scene)
    : document_(document),
      accessors_(accessors),
      nodes_(nodes),
      scene_(scene),
      materials_(document, scene) {}

std::vector<GltfShapes::Part> GltfShapes::parts_of(const JsonPlace& node, const JsonPlace& mesh) {
    const MeshPose pose = pose_of(document_, nodes_, accessors_, node, mesh);
    std::vector<Part> parts;
    for (const JsonPlace& primitive : mesh.at("primitives").elements()) {
        const GltfLook& look = materials_.look_of(primitive);
        auto triangles = triangles_of(accessors_, primitive, pose, look.uv_set, scene_.warnings);
        if (triangles) parts.push_back({std::move(*triangles), &look, primitive.where()});
    }
    return parts;
}

std::vector<ShapeDescription> GltfShapes::of(const JsonPlace& node, const JsonPlace& mesh) {
    std::vector<Part> parts = parts_of(node, mesh);
    const bool has_glass = std::any_of(parts.begin(), parts.end(),
                                       [](const Part& p) { return p.look->glass.has_value(); });
    std::vector<std::vector<bool>> closed;
    if (has_glass) {
        std::vector<const TriangleMesh*> meshes;
        for (const Part& part : parts) meshes.push_back(&part.mesh);
        closed = closed_triangles(meshes);
    }
    std::vector<ShapeDescription> shapes;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].look->glass)
            add_glass(parts[i], closed[i], shapes);
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

void GltfShapes::add_glass(const Part& part, const std::vector<bool>& closed,
                           std::vector<ShapeDescription>& shapes) {
    std::vector<bool> open = closed;
    open.flip();
    TriangleMesh solid = chosen_triangles(part.mesh, closed);
    TriangleMesh panes = chosen_triangles(part.mesh, open);
    if (!panes.triangles.empty()) shapes.push_back(pane_of(part, std::move(panes)));
    if (!solid.triangles.empty()) shapes.push_back(solid_of(part, std::move(solid)));
}

ShapeDescription GltfShapes::pane_of(const Part& part, TriangleMesh mesh) {
    const GltfLook::Glass& glass = *part.look->glass;
    if (glass.has_volume)
        scene_.warnings.add(part.where,
                            "glass has a volume, but its surface is open: it is a thin pane");
    if (glass.colour != Vec3d(1))
        scene_.warnings.add(part.where, "the colour of thin glass is left out");
    ShapeDescription shape = shape_of(part, std::move(mesh));
    shape.material = glass.pane;
    return shape;
}

/// A straight way through solid glass of mean length has its colour.
ShapeDescription GltfShapes::solid_of(const Part& part, TriangleMesh mesh) {
    const GltfLook::Glass& glass = *part.look->glass;
    Vec3d absorption = glass.absorption;
    const double chord = mean_chord(mesh);
    if (chord > 0) absorption += absorption_over(chord, glass.colour);
    ShapeDescription shape = shape_of(part, std::move(mesh));
    if (absorption != Vec3d(0)) shape.media.inside = materials_.medium_of(absorption);
    return shape;
}

}  // namespace sunfleck::engine
