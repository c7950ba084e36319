// SceneFolder: builds a procedural scene from text and meshes.
#pragma once

#include "procedural/mesh.h"
#include "procedural/scene_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// The statements before WorldBegin.
struct SceneHead {
    std::string_view unit;    // length of a unit, and the direction of up
    std::string_view camera;  // statements: LookAt, Camera
    int width = 512;
    int height = 512;
    int max_depth = 32;
};

class SceneFolder {
public:
    /// Begins the text: comments, the mirrored frame (for right-handed pictures), camera, film and
    /// hints, WorldBegin.
    SceneFolder(const ProceduralScene& scene, const SceneHead& head);

    /// Adds statements unchanged.
    void text(std::string_view statements);

    /// Adds a mesh under a comment. Meshes of more than 60 triangles become a file,
    /// geometry/PART.ply.
    /// @param part      description, unique and usable as a file name.
    /// @param material  a named material.
    void add(const std::string& part, std::string_view material, const Mesh& mesh);

    std::vector<SceneFile> files() &&;

private:
    std::vector<SceneFile> files_;  // the first is the text
};

/// Returns the text with each mark replaced.
std::string replaced(std::string text, std::string_view mark, std::string_view by);

}  // namespace sunfleck::engine
