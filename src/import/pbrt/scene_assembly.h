// A scene put together by calls, statement by statement, in place of a scene file.
//
// In:  statements with the place, material and media that a file's graphics state would give them.
// Out: the finished scene. Statements that others name may come later, but textures come first.
#pragma once

#include "import/pbrt/parameters.h"
#include "scene/description.h"

#include <memory>
#include <optional>
#include <string>

namespace sunfleck::engine {

/// What a shape has beside its own parameters.
struct ShapePlacement {
    std::string material;  // empty: pbrt-v4's default, diffuse 0.5
    Matrix to_world;
    std::optional<Statement> area_light;
    std::string inside_medium;
    std::string outside_medium;
    bool reverse_orientation = false;
    std::string object;  // that it is a part of; empty: it is in the world
};

class SceneAssembly {
public:
    /// @param path  stands for the path of a scene file: its folder is that of relative names, and
    ///              messages about the whole scene have its name.
    explicit SceneAssembly(const std::string& path);
    ~SceneAssembly();
    SceneAssembly(SceneAssembly&&) noexcept;
    SceneAssembly& operator=(SceneAssembly&&) noexcept;
    SceneAssembly(const SceneAssembly&) = delete;
    SceneAssembly& operator=(const SceneAssembly&) = delete;

    // Each throws Error for an unknown type and for parameters that cannot be used, and then
    // changes nothing. Files that are missing are told by finish().

    /// @param medium  around the camera.
    void set_camera(Statement camera, const Matrix& to_world, const std::string& medium);
    void set_film(Statement film);
    void set_filter(Statement filter);

    void add_material(const std::string& name, Statement material);
    /// @param kind  "float" or "spectrum".
    void add_texture(const std::string& kind, const std::string& name, Statement texture,
                     const Matrix& to_world);
    void add_medium(Statement medium);
    /// @param medium  around the light.
    void add_light(const Statement& light, const Matrix& to_world, const std::string& medium);
    void add_shape(const Statement& shape, const ShapePlacement& placement);
    /// @param object  may be made later.
    void add_instance(const std::string& object, const Matrix& to_world,
                      const SourceLocation& where);

    /// Returns the scene of all statements so far, which stay.
    /// @throws Error  as finish_scene() does.
    SceneDescription finish() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sunfleck::engine
