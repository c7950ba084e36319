// Places without folders, so that a name is the same wherever the scene lies.
#include "import/pbrt/names.h"

#include <filesystem>

namespace sunfleck::engine {
namespace {

/// Returns "sphere scene.pbrt:12".
std::string by_place(const Statement& statement) {
    const std::string file = std::filesystem::path(statement.where.file).filename().string();
    return statement.type + ' ' + file + ':' + std::to_string(statement.where.line);
}

/// Returns "bunny" of "meshes/bunny.ply" and of "meshes/bunny.ply.gz".
std::string without_endings(const std::string& file) {
    std::filesystem::path name = std::filesystem::path(file).filename();
    if (name.extension() == ".gz") name = name.stem();
    return name.stem().string();
}

}  // namespace

std::string shape_name(const Statement& statement) {
    if (statement.type == "plymesh")
        if (const auto file = statement.text("filename")) {
            std::string name = without_endings(*file);
            if (!name.empty()) return name;
        }
    return by_place(statement);
}

std::string material_name(const Statement& statement) {
    return statement.where.file.empty() ? "default" : by_place(statement);
}

}  // namespace sunfleck::engine
