// Shapes of a node's mesh, with their materials; glass divided into solid and thin.
#pragma once

#include "import/gltf/glass.h"
#include "import/gltf/materials.h"
#include "import/gltf/meshes.h"

#include <vector>

namespace sunfleck::engine {

class GltfShapes {
public:
    /// All must outlive this.
    GltfShapes(GltfDocument& document, const Accessors& accessors, const GltfNodes& nodes,
               SceneDescription& scene, const ImportSettings& settings);

    /// Returns the shapes of a mesh as a node shows it, in the mesh's own frame; in the world if
    /// the node has a skin.
    std::vector<ShapeDescription> of(const GltfNode& node, const JsonPlace& mesh);

    /// Tells in one line which glass is solid and which is thin, unless the user has said so.
    void tell_glass() const;

private:
    /// A primitive.
    struct Part {
        TriangleMesh mesh;
        const GltfLook* look;
        SourceLocation where;
    };

    std::vector<Part> parts_of(const GltfNode& node, const JsonPlace& mesh);
    static ShapeDescription shape_of(const Part& part, TriangleMesh mesh);
    void add_glass(Part& part, const SurfaceSides& sides, std::vector<ShapeDescription>& shapes);
    ShapeDescription pane_of(const Part& part, TriangleMesh mesh);
    ShapeDescription solid_of(const Part& part, TriangleMesh mesh, bool is_closed);

    const GltfDocument& document_;
    const Accessors& accessors_;
    const GltfNodes& nodes_;
    SceneDescription& scene_;
    GlassRule rule_;
    GltfMaterials materials_;
    std::size_t solid_glass_ = 0;  // parts
    std::size_t thin_glass_ = 0;
};

}  // namespace sunfleck::engine
