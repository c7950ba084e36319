// A procedural scene while it is put together: its text, and the meshes beside it.
#pragma once

#include "procedural/mesh.h"
#include "procedural/scene_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// What stands before WorldBegin.
struct SceneHead {
    std::string_view unit;    // what one unit is, and where up is
    std::string_view camera;  // statements: LookAt, Camera
    int width = 512;
    int height = 512;
    int max_depth = 32;
};

class SceneFolder {
public:
    /// Begins the text: comments, the mirrored frame (so that pictures are right-handed), camera,
    /// film and hints, WorldBegin.
    SceneFolder(const ProceduralScene& scene, const SceneHead& head);

    /// Adds statements as they are.
    void text(std::string_view statements);

    /// Adds a mesh under a comment. Meshes of more than 60 triangles get a file,
    /// geometry/PART.ply.
    /// @param part      what it is; a name for a file, used once.
    /// @param material  a named material.
    void add(const std::string& part, std::string_view material, const Mesh& mesh);

    std::vector<SceneFile> files() &&;

private:
    std::vector<SceneFile> files_;  // the first is the text
};

/// The text with each mark replaced.
std::string replaced(std::string text, std::string_view mark, std::string_view by);

}  // namespace sunfleck::engine
