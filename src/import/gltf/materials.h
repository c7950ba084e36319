// Materials of glTF: metallic-roughness, glass, emission, as materials of ours.
//
// A surface is a diffuse base under a rough clear coat, or a metal, mixed by `metallic`. With
// KHR_materials_transmission it is glass.
// Source: glTF 2.0 Specification, section 3.9 and appendix B; the KHR_materials extensions.
#pragma once

#include "import/gltf/textures.h"
#include "scene/description.h"

#include <cstdint>
#include <map>
#include <optional>

namespace sunfleck::engine {

/// What a material makes of a surface.
struct GltfLook {
    std::uint32_t material = 0;  // index into SceneDescription::materials
    std::optional<AreaEmission> emission{};
    Cover cover{};                        // null: opaque
    std::optional<FloatTexture> alpha{};  // of `cover`, for emission
    std::uint64_t uv_set = 0;
    /// Of glass: the material of its panes, what a straight way through it lets pass, and the
    /// medium within.
    struct Glass {
        std::uint32_t pane = 0;
        Vec3d colour{1};
        Vec3d absorption{0};  // per metre, linear sRGB
        bool has_volume = false;
    };
    std::optional<Glass> glass{};
};

/// The parameters of metallic-roughness, with their textures.
struct GltfPbr {
    Vec3d base{1};
    double alpha = 1;
    double metallic = 1;
    double roughness = 1;
    std::optional<GltfTextures::Slot> colour{};
    std::optional<GltfTextures::Slot> green{};  // roughness
    std::optional<GltfTextures::Slot> blue{};   // metallic
    std::optional<std::uint64_t> uv_set{};      // of all textures, if there are any
};

class GltfMaterials {
public:
    /// All must outlive this.
    GltfMaterials(GltfDocument& document, SceneDescription& scene);

    /// Returns the look of a primitive: of its material, or glTF's default.
    const GltfLook& look_of(const JsonPlace& primitive);

    /// Returns a medium that absorbs so much per metre. @param absorption  linear sRGB.
    MediumNumber medium_of(const Vec3d& absorption);

private:
    GltfLook made(const std::optional<JsonPlace>& material);
    std::uint32_t add(Material material, const BumpMap& bump_map);
    std::uint32_t add_opaque(const GltfPbr& pbr, double ior, const BumpMap& bump_map);
    void add_alpha(const JsonPlace& material, const GltfPbr& pbr, GltfLook& look);
    void add_glass(const JsonPlace& material, GltfPbr& pbr, double ior, const BumpMap& bump_map,
                   GltfLook& look);

    GltfDocument& document_;
    SceneDescription& scene_;
    GltfTextures textures_;
    std::map<std::optional<std::size_t>, GltfLook> looks_;
};

}  // namespace sunfleck::engine
