// Metallic-roughness: the parameters of a glTF material, and our textures of them.
//
// Source: glTF 2.0 Specification, section 3.9.2; KHR_materials_anisotropy.
#pragma once

#include "import/gltf/textures.h"
#include "material/material.h"

#include <optional>
#include <vector>

namespace sunfleck::engine {

/// An index that reflects all: KHR_materials_ior writes 0 for it.
inline constexpr double kInfiniteIndex = 1e9;

/// The parameters of a surface, with their textures.
struct GltfPbr {
    Vec3d base{1};
    double alpha = 1;
    double metallic = 1;
    double roughness = 1;
    double ior = 1.5;
    double anisotropy = 0;  // strength in [0,1]
    std::optional<GltfTextures::Slot> colour{};
    std::optional<GltfTextures::Slot> opacity{};    // alpha of `colour`, linear; none if it is 1
    std::optional<GltfTextures::Slot> green{};      // roughness
    std::optional<GltfTextures::Slot> blue{};       // metallic
    std::optional<GltfTextures::Slot> direction{};  // of anisotropy: its strength
    GltfVertices vertices{};
};

/// Returns the parameters of a material; glTF's default without one.
GltfPbr pbr_of(const std::optional<JsonPlace>& material, GltfTextures& textures,
               const GltfVertices& vertices);

/// Returns the base colour: of the factor, the texture and the vertices.
SpectrumTexture base_colour(const GltfPbr& pbr);
/// Returns a colour with its texture, if it has one.
SpectrumTexture colour_of(const std::optional<GltfTextures::Slot>& slot, const Vec3d& factor);
/// Returns a factor times its texture, if it has one.
FloatTexture number_of(const std::optional<GltfTextures::Slot>& slot, double factor);
/// Returns alpha: of the factor, the texture and the vertices.
FloatTexture alpha_of(const GltfPbr& pbr);
/// Returns the GGX alphas: the square of the roughness, wider along the tangent by the anisotropy.
Roughness roughness_of(const GltfPbr& pbr);
FloatTexture metallic_of(const GltfPbr& pbr);

/// Returns the mean of a texture of one channel; 1 without one.
double mean_of(const std::optional<GltfTextures::Slot>& slot);

/// Returns a coat's facets. None if it is smooth.
/// @param strength  of the anisotropy, in [0,1].
std::optional<Ggx> facets_of(double roughness, double strength = 0);

/// A roughness that varies, as a mix of a few: a coat's facets have one width.
struct RoughnessSteps {
    std::vector<double> roughness;      // increasing; one at least
    std::vector<FloatTexture> amounts;  // of each step but the first, in a mix with all before it
};

/// Returns the roughness in steps of 1/8 between which it is interpolated; of a texture that hardly
/// varies, its mean alone.
RoughnessSteps steps_of(const std::optional<GltfTextures::Slot>& slot, double factor);

}  // namespace sunfleck::engine
