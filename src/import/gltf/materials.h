// Materials of glTF: metallic-roughness, glass, emission, as materials of ours.
//
// A surface is opaque (import/gltf/opaque.h) or, with KHR_materials_transmission, glass.
// Source: glTF 2.0 Specification, section 3.9 and appendix B; the KHR_materials extensions.
#pragma once

#include "import/gltf/opaque.h"
#include "import/gltf/volumes.h"
#include "scene/import_settings.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sunfleck::engine {

/// What a material makes of a surface.
struct GltfLook {
    std::uint32_t material = 0;  // index into SceneDescription::materials
    std::optional<AreaEmission> emission{};
    Cover cover{};                        // null: opaque
    std::optional<FloatTexture> alpha{};  // of `cover`, for emission
    double tangent_turn = 0;              // of anisotropy, radians from u to v
    bool is_of_vertices = false;          // made for one primitive and the order of its triangles
    /// Of glass: the material of its panes, what a straight way through it lets pass, and the
    /// medium within.
    struct Glass {
        std::uint32_t pane = 0;
        Vec3d colour{1};
        GltfVolume volume{};
        bool has_texture = false;  // of its colour
        bool is_rough = false;
    };
    std::optional<Glass> glass{};
};

class GltfMaterials {
public:
    /// All must outlive this.
    /// @param settings  variant and unit of emission.
    /// @throws Error  for a variant that the file lacks.
    GltfMaterials(GltfDocument& document, SceneDescription& scene, const ImportSettings& settings);

    /// Returns the numbers of the texture coordinates that a primitive's material uses. The first
    /// are those that the mesh is to have; there is always one.
    std::vector<std::uint64_t> uv_sets_of(const JsonPlace& primitive) const;

    /// Returns the look of a primitive: of its material, or glTF's default.
    /// @param vertices  of the primitive.
    const GltfLook& look_of(const JsonPlace& primitive, const GltfVertices& vertices);

private:
    /// Number of a material, and the primitive if its vertices carry something; a text for all
    /// whose vertices have no texture coordinates.
    using Key = std::pair<std::optional<std::size_t>, std::string>;

    std::optional<JsonPlace> material_of(const JsonPlace& primitive) const;
    GltfLook made(const std::optional<JsonPlace>& material, const GltfVertices& vertices);
    GltfLook made_unlit(const JsonPlace& material, const GltfPbr& pbr);
    void add_alpha(const JsonPlace& material, const GltfPbr& pbr, GltfLook& look);
    bool add_glass(const JsonPlace& material, const GltfPbr& pbr, GltfSurface& surface,
                   GltfLook& look);
    void add_emission(const JsonPlace& material, const GltfVertices& vertices, GltfLook& look);
    BumpMap normal_map_of(const JsonPlace& material, const GltfVertices& vertices);

    GltfDocument& document_;
    SceneDescription& scene_;
    GltfTextures textures_;
    GltfCoats coats_;
    std::optional<std::size_t> variant_{};
    bool is_in_watts_ = false;  // emission
    bool told_watts_ = false;
    std::map<Key, GltfLook> looks_;
};

}  // namespace sunfleck::engine
