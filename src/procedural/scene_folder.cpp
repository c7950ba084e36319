// The common head of the scenes, and parts one by one.

#include "procedural/scene_folder.h"

#include <utility>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kReadable = 60;  // triangles

constexpr std::string_view kHead = R"(# Sunfleck, scene @NAME@: @WHAT@.
# Made by "sunfleck scene @NAME@". Dedicated to the public domain (CC0 1.0).
# @UNIT@; the first line makes the picture right-handed.
Scale -1 1 1
@CAMERA@Film "rgb" "string filename" "@NAME@.exr"
    "integer xresolution" @WIDTH@ "integer yresolution" @HEIGHT@
PixelFilter "box"
Sampler "halton" "integer pixelsamples" 256
Integrator "sppm" "integer maxdepth" @DEPTH@

WorldBegin
)";

}  // namespace

std::string replaced(std::string text, std::string_view mark, std::string_view by) {
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at))
        text.replace(at, mark.size(), by);
    return text;
}

SceneFolder::SceneFolder(const ProceduralScene& scene, const SceneHead& head) {
    std::string text = replaced(std::string(kHead), "@NAME@", scene.name);
    text = replaced(text, "@WHAT@", scene.what);
    text = replaced(text, "@UNIT@", head.unit);
    text = replaced(text, "@CAMERA@", head.camera);
    text = replaced(text, "@WIDTH@", std::to_string(head.width));
    text = replaced(text, "@HEIGHT@", std::to_string(head.height));
    text = replaced(text, "@DEPTH@", std::to_string(head.max_depth));
    files_.push_back({scene.name + ".pbrt", text});
}

void SceneFolder::text(std::string_view statements) {
    files_[0].bytes += statements;
}

void SceneFolder::add(const std::string& part, std::string_view material, const Mesh& mesh) {
    text("\n# " + part + "\nNamedMaterial \"" + std::string(material) + "\"\n");
    if (mesh.triangles.size() <= kReadable) return text(shape_text(mesh));
    const std::string file = "geometry/" + part + ".ply";
    text("Shape \"plymesh\" \"string filename\" \"" + file + "\"\n");
    files_.push_back({file, ply_bytes(mesh)});
}

std::vector<SceneFile> SceneFolder::files() && {
    return std::move(files_);
}

}  // namespace sunfleck::engine
