// What extensions put on plastic and metal.
#include "import/gltf/opaque.h"

#include "gltf_files.h"

namespace sunfleck::engine {
namespace {

using testing_support::square_json;
using testing_support::textured_square_json;
using testing_support::warns;

class GltfOpaque : public testing_support::GltfFiles {
protected:
    /// The scene of one square. @param metallic  0 or 1. @param extension  its name and content.
    SceneDescription with(int metallic, const std::string& extension) const {
        return read(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"materials":[{
"pbrMetallicRoughness":{"metallicFactor":)" +
                    std::to_string(metallic) + R"(,"roughnessFactor":0.5},"extensions":{)" +
                    extension + "}}]," + square_json(R"(,"material":0)"));
    }
    static const Material& material_of(const SceneDescription& scene) {
        return scene.materials.at(scene.shapes.at(0).material);
    }
};

/// Of index 1.5 and its own roughness, in the place of the coat of plastic, as far as it covers.
TEST_F(GltfOpaque, clearcoat_covers_plastic_and_metal) {
    const std::string half = R"("KHR_materials_clearcoat":{"clearcoatFactor":0.25,
"clearcoatRoughnessFactor":0.8})";
    const SceneDescription plastic = with(0, half);
    const auto& mix = std::get<MixMaterial>(material_of(plastic));
    EXPECT_EQ(mix.amount.constant(), 0.25F);
    const auto facets = [&](std::uint32_t number) {
        return *std::get<CoatedDiffuseMaterial>(plastic.materials.at(number)).coat->facets();
    };
    EXPECT_FLOAT_EQ(facets(mix.components[0]).alpha_x, 0.25F);
    EXPECT_FLOAT_EQ(facets(mix.components[1]).alpha_x, 0.64F);
    const SceneDescription metal = with(1, R"("KHR_materials_clearcoat":{"clearcoatFactor":1})");
    const auto& coated = std::get<CoatedConductorMaterial>(material_of(metal));
    EXPECT_EQ(coated.coat->eta(), 1.5F);
    EXPECT_FALSE(coated.coat->facets());
    EXPECT_FLOAT_EQ(coated.metal.roughness.u.constant(), 0.25F);
}

/// Reflection along the normal is that of the index times the luminance; without it all is matt.
TEST_F(GltfOpaque, specular_scales_the_reflection_of_plastic) {
    const SceneDescription scene = with(
        0, R"("KHR_materials_specular":{"specularFactor":0.75,"specularColorFactor":[2,2,2]})");
    const auto& mix = std::get<MixMaterial>(material_of(scene));
    EXPECT_FLOAT_EQ(mix.amount.constant(), 0.25F);
    EXPECT_TRUE(std::holds_alternative<DiffuseMaterial>(scene.materials.at(mix.components[1])));
    const auto& plastic = std::get<CoatedDiffuseMaterial>(scene.materials.at(mix.components[0]));
    EXPECT_NEAR(plastic.coat->reflectance(1), 0.08F, 1e-5F);
    EXPECT_TRUE(warns(with(0, R"("KHR_materials_specular":{"specularColorFactor":[1,0,0]})"),
                      "colour of reflection is left out"));
}

TEST_F(GltfOpaque, iridescence_is_a_film_on_metal) {
    const std::string film = R"("KHR_materials_iridescence":{"iridescenceFactor":1,
"iridescenceIor":1.8,"iridescenceThicknessMaximum":550})";
    const SceneDescription scene = with(1, film);
    const auto& metal = std::get<IridescentConductorMaterial>(material_of(scene));
    EXPECT_EQ(metal.film_eta, 1.8F);
    EXPECT_EQ(metal.thickness.constant(), 550);
    EXPECT_TRUE(warns(with(0, film),
                      "no film lies on what is not metal: it reflects 4.0% along the normal at all "
                      "wavelengths, with the film 4.0% to 13.5%"));
}

TEST_F(GltfOpaque, diffuse_transmission_is_a_share_of_the_surface) {
    const SceneDescription scene = with(0, R"("KHR_materials_diffuse_transmission":{
"diffuseTransmissionFactor":0.3,"diffuseTransmissionColorFactor":[0.5,0.5,0.5]})");
    const auto& mix = std::get<MixMaterial>(material_of(scene));
    EXPECT_EQ(mix.amount.constant(), 0.3F);
    const auto& sheet =
        std::get<DiffuseTransmissionMaterial>(scene.materials.at(mix.components[1]));
    EXPECT_EQ(sheet.reflectance.curve()(550), 0);
    EXPECT_NEAR(sheet.transmittance.curve()(550), 0.5F, 1e-3F);
}

/// Four texels of green 0, 1/3, 2/3 and 1: coats in steps of 1/8, between which a mix interpolates.
TEST_F(GltfOpaque, roughness_of_coats_follows_its_texture) {
    const std::string file =
        R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"images":[{"uri":"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAQAAAABCAIAAAB2XpiaAAAAE0lEQVR42mNgAIJQBoZVDAz/GQAIBQH/fuf4cgAAAABJRU5ErkJggg=="}],
"textures":[{"source":0,"sampler":0}],"samplers":[{"magFilter":9728}],
"materials":[{"pbrMetallicRoughness":{"metallicFactor":0,"metallicRoughnessTexture":{"index":0}}},
{"pbrMetallicRoughness":{"metallicFactor":1},"extensions":{"KHR_materials_clearcoat":{
"clearcoatFactor":1,"clearcoatRoughnessFactor":0.5,"clearcoatRoughnessTexture":{"index":0}}}}],)" +
        textured_square_json(R"(,"material":0},
{"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,"material":1)");
    const SceneDescription scene = read(file);
    EXPECT_FALSE(warns(scene, "mean of this texture"));
    const auto coat_of = [&](std::uint32_t number) -> const Coat& {
        const Material& material = scene.materials.at(number);
        if (const auto* plastic = std::get_if<CoatedDiffuseMaterial>(&material))
            return *plastic->coat;
        return *std::get<CoatedConductorMaterial>(material).coat;
    };
    // The mean roughness of the mix at a point.
    const auto roughness_at = [&](std::uint32_t number, const TexturePoint& point) {
        const auto mean = [&](const auto& self, std::uint32_t material) -> double {
            const auto* mix = std::get_if<MixMaterial>(&scene.materials.at(material));
            if (mix == nullptr) {
                const auto& facets = coat_of(material).facets();
                return facets ? std::sqrt(double{facets->alpha_x}) : 0;
            }
            const double share{mix->amount.at(point)};
            return (1 - share) * self(self, mix->components[0]) +
                   share * self(self, mix->components[1]);
        };
        return mean(mean, number);
    };
    for (int texel = 0; texel < 4; ++texel) {
        const TexturePoint point(Vec3(0), Vec3(0, 0, 1),
                                 {(static_cast<float>(texel) + 0.5F) / 4, 0.5F});
        EXPECT_NEAR(roughness_at(scene.shapes.at(0).material, point), texel / 3.0, 1e-3);
        EXPECT_NEAR(roughness_at(scene.shapes.at(1).material, point), texel / 6.0, 1e-3);
    }
}

}  // namespace
}  // namespace sunfleck::engine
