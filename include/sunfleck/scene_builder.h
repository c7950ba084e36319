// Makes a scene in memory, call by call, in place of a scene file.
//
// Types and parameters are those of pbrt-v4's statements (docs/reference/scenes.md). Calls may come
// in any order, but textures before what uses them.
#pragma once

#include <sunfleck/export.h>
#include <sunfleck/parameters.h>
#include <sunfleck/scene.h>
#include <sunfleck/transform.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace sunfleck {

/// An indexed triangle mesh. Normals and uvs may be empty.
struct SUNFLECK_API Mesh {
    std::span<const float> positions;          // x y z of each corner
    std::span<const std::uint32_t> triangles;  // three corners each
    std::span<const float> normals{};          // x y z of each corner: shades smoothly
    std::span<const float> uvs{};              // u v of each corner
};

/// Where and of what a shape is.
struct SUNFLECK_API ShapeOptions {
    std::string material{};  // its name; empty: diffuse grey, of reflectance 0.5
    Transform to_world{};
    std::optional<Parameters>
        area_light{};             // parameters of its diffuse area light; none: it is dark
    std::string inside_medium{};  // on the side that normals point away from
    std::string outside_medium{};
    bool reverse_orientation = false;  // turns the normals
    std::string object{};              // adds the shape to this object, to be placed by instances
};

/// For one thread at a time. Spans are copied.
/// Calls throw Error for an unknown type and for values that cannot be used, and then change
/// nothing. build() throws also for materials, media and objects that were never made, for textures
/// of materials, and for missing files. A builder that was moved from is as if new.
class SUNFLECK_API SceneBuilder {
public:
    /// @param folder  of relative file names.
    explicit SceneBuilder(const std::string& folder = ".");
    ~SceneBuilder();
    SceneBuilder(SceneBuilder&&) noexcept;
    SceneBuilder& operator=(SceneBuilder&&) noexcept;
    SceneBuilder(const SceneBuilder&) = delete;
    SceneBuilder& operator=(const SceneBuilder&) = delete;

    /// @param type  "perspective", "orthographic" or "spherical". @param medium  around the camera.
    void camera(const std::string& type, const Parameters& parameters, const Transform& to_world,
                const std::string& medium = "");
    void film(int width, int height, const Parameters& parameters = {});
    /// @param type  "gaussian", "box", "triangle", "mitchell" or "sinc".
    void filter(const std::string& type, const Parameters& parameters = {});

    void material(const std::string& name, const std::string& type,
                  const Parameters& parameters = {});
    /// @param kind  "float" or "spectrum".
    void texture(const std::string& name, const std::string& kind, const std::string& type,
                 const Parameters& parameters = {}, const Transform& to_world = {});
    void medium(const std::string& name, const std::string& type,
                const Parameters& parameters = {});
    /// @param medium  around the light.
    void light(const std::string& type, const Parameters& parameters,
               const Transform& to_world = {}, const std::string& medium = "");
    void shape(const std::string& type, const Parameters& parameters,
               const ShapeOptions& options = {});
    void mesh(const Mesh& mesh, const ShapeOptions& options = {});
    /// Places an object, which may be made later.
    void instance(const std::string& object, const Transform& to_world = {});

    /// The scene of all calls so far; the builder is empty then, as if new. If it throws, the
    /// builder is unchanged, so that what was wrong can be mended by further calls.
    Scene build(const SceneOptions& options = {});

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sunfleck
