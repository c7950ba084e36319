// Materials: what each part of a glTF material becomes.
#include "import/gltf/materials.h"

#include "gltf_files.h"
#include "import/gltf/units.h"
#include "math/wavelengths.h"
#include "scene/scene.h"

namespace sunfleck::engine {
namespace {

using testing_support::expect_same;
using testing_support::square_json;
using testing_support::textured_square_json;
using testing_support::warns;

class GltfMaterial : public testing_support::GltfFiles {
protected:
    static std::string scene_of(const std::string& material) {
        return R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"materials":[{)" + material +
               "}]," + square_json(R"(,"material":0)");
    }
    /// The scene of one square of this material.
    SceneDescription with(const std::string& material) const { return read(scene_of(material)); }

    static const Material& material_of(const SceneDescription& scene) {
        return scene.materials.at(scene.shapes.at(0).material);
    }
};

constexpr const char* kTwoTexels =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAEU"
    "lEQVR42mP4z8Dwn6GBoQEADvwC/0yqyAQAAAAASUVORK5CYII=";

TEST_F(GltfMaterial, that_is_missing_is_white_metal_of_roughness_one) {
    const SceneDescription scene =
        read(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)" + square_json());
    const auto& metal = std::get<ConductorMaterial>(material_of(scene));
    EXPECT_EQ(metal.reflectance->curve().to_rgb(), Spectrum::constant(1).to_rgb());
    EXPECT_EQ(metal.roughness.u.constant(), 1);
    EXPECT_TRUE(metal.roughness.gives_back);
}

TEST_F(GltfMaterial, of_no_metal_is_a_base_under_a_coat) {
    const SceneDescription scene = with(
        R"("pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.5,"baseColorFactor":[0.2,0.4,0.6,1]},
"extensions":{"KHR_materials_ior":{"ior":1.8}})");
    const auto& plastic = std::get<CoatedDiffuseMaterial>(material_of(scene));
    expect_same(plastic.reflectance.curve(), Spectrum::rgb_albedo({0.2F, 0.4F, 0.6F}));
    EXPECT_FLOAT_EQ(plastic.coat->eta(), 1.8F);
    EXPECT_FLOAT_EQ(plastic.coat->facets()->alpha_x, 0.25F) << "alpha is roughness squared";
    EXPECT_TRUE(plastic.whole);
}

TEST_F(GltfMaterial, half_metal_is_a_mix) {
    const SceneDescription scene = with(R"("pbrMetallicRoughness":{"metallicFactor":0.5})");
    const auto& mix = std::get<MixMaterial>(material_of(scene));
    EXPECT_EQ(mix.amount.constant(), 0.5F);
    EXPECT_TRUE(std::holds_alternative<CoatedDiffuseMaterial>(scene.materials[mix.components[0]]));
    EXPECT_TRUE(std::holds_alternative<ConductorMaterial>(scene.materials[mix.components[1]]));
}

/// A square is open: glass in it is a pane, solid or not.
TEST_F(GltfMaterial, glass_of_an_open_surface_is_thin) {
    const SceneDescription scene = with(
        R"("pbrMetallicRoughness":{"metallicFactor":0},"extensions":{"KHR_materials_transmission":{"transmissionFactor":1},
"KHR_materials_volume":{"thicknessFactor":1}})");
    EXPECT_TRUE(std::holds_alternative<ThinDielectricMaterial>(material_of(scene)));
    EXPECT_TRUE(warns(scene, "scene.gltf: warning: glass: 1 part open, so thin panes"));
    EXPECT_EQ(scene.materials.size(), 2U) << "solid and thin, and nothing opaque";
}

/// Where a texture says metal, nothing passes.
TEST_F(GltfMaterial, metal_is_no_glass) {
    const std::string glass =
        R"(},"extensions":{"KHR_materials_transmission":{"transmissionFactor":0.5}})";
    const SceneDescription metal = with(R"("pbrMetallicRoughness":{"metallicFactor":1)" + glass);
    EXPECT_TRUE(std::holds_alternative<ConductorMaterial>(material_of(metal)));
    const SceneDescription both = with(R"("pbrMetallicRoughness":{"metallicFactor":0.6)" + glass);
    EXPECT_NEAR(std::get<MixMaterial>(material_of(both)).amount.at({}), 0.2F, 1e-6F);
}

/// Indices of the lines d, F and C are those that Abbe's number was defined by.
TEST_F(GltfMaterial, dispersion_is_cauchys_law) {
    const SceneDescription scene = with(
        R"("pbrMetallicRoughness":{"metallicFactor":0},"extensions":{"KHR_materials_transmission":{"transmissionFactor":1},
"KHR_materials_ior":{"ior":1.6},"KHR_materials_dispersion":{"dispersion":0.5}})");
    const Spectrum& eta = std::get<ThinDielectricMaterial>(material_of(scene)).eta;
    const auto at = [&](float nm) { return static_cast<double>(eta(nm)); };
    EXPECT_NEAR(at(587.56F), 1.6, 1e-5);
    EXPECT_NEAR((at(587.56F) - 1) / (at(486.13F) - at(656.27F)), 20 / 0.5, 0.05);
}

TEST_F(GltfMaterial, emission_is_in_nits) {
    const SceneDescription scene = with(R"("emissiveFactor":[1,1,1],"doubleSided":true,
"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":683}})");
    const AreaEmission& emission = *scene.shapes[0].emission;
    EXPECT_NEAR(emission.radiance.luminance(), 1, 1e-3);
    EXPECT_TRUE(emission.two_sided);
    EXPECT_FALSE(with("").shapes[0].emission);
}

/// Told once; and a setting goes before what wrote the file.
TEST_F(GltfMaterial, emission_of_blender_is_in_watts) {
    const std::string members =
        scene_of(R"("emissiveFactor":[1,1,1],"extensions":{"KHR_materials_emissive_strength":
{"emissiveStrength":5}})");
    const std::string file =
        written("blender.gltf",
                R"({"asset":{"version":"2.0","generator":"Khronos glTF Blender I/O v3.4.50"},)" +
                    members + "}");
    const auto luminance = [&](const ImportSettings& settings) {
        return read_gltf(file, settings).shapes.at(0).emission->radiance.luminance();
    };
    ImportSettings settings;
    EXPECT_NEAR(luminance(settings), 5, 1e-3);
    EXPECT_TRUE(warns(read_gltf(file),
                      "materials[0]: warning: emission is taken in W/(sr m2), "
                      "because \"Khronos glTF Blender I/O v3.4.50\" wrote"));
    settings.emission_unit = EmissionUnit::nit;
    EXPECT_NEAR(luminance(settings), 5.0 / 683, 1e-5);
    EXPECT_FALSE(warns(read_gltf(file, settings), "emission is taken"));
}

TEST_F(GltfMaterial, variants_are_chosen_by_name) {
    const std::string members =
        R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"extensions":{"KHR_materials_variants":{"variants":[{"name":"day"},{"name":"night"}]}},
"materials":[{},{"pbrMetallicRoughness":{"metallicFactor":0},"extensions":{"KHR_materials_transmission":{"transmissionFactor":1}}}],)" +
        square_json(R"(,"material":0,"extensions":{"KHR_materials_variants":{"mappings":[
{"material":0,"variants":[0]},{"material":1,"variants":[1]}]}})");
    ImportSettings settings;
    const auto is_glass = [&](const std::string& variant) {
        settings.variant = variant;
        return std::holds_alternative<ThinDielectricMaterial>(
            material_of(read_gltf(gltf(members), settings)));
    };
    EXPECT_FALSE(is_glass(""));
    EXPECT_FALSE(is_glass("day"));
    EXPECT_TRUE(is_glass("night"));
    try {
        is_glass("dusk");
        FAIL() << "there is no such variant";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what())
                      .find("has no variant \"dusk\" (--variant); write one of \"day\", \"night\""),
                  std::string::npos)
            << error.what();
    }
}

/// A picture of 1.0 is 1 cd/m2.
TEST_F(GltfMaterial, unlit_emits_its_colour_and_reflects_nothing) {
    const SceneDescription scene = with(R"("extensions":{"KHR_materials_unlit":{}})");
    EXPECT_NEAR(scene.shapes[0].emission->radiance.luminance(), 1.0 / 683, 1e-6);
    EXPECT_TRUE(scene.shapes[0].emission->two_sided);
    EXPECT_EQ(std::get<DiffuseMaterial>(material_of(scene)).reflectance.curve()(550), 0);
}

TEST_F(GltfMaterial, thin_glass_colours_what_passes) {
    const SceneDescription scene = with(
        R"("pbrMetallicRoughness":{"baseColorFactor":[0.2,0.4,0.6,1],"roughnessFactor":0,"metallicFactor":0},
"extensions":{"KHR_materials_transmission":{"transmissionFactor":1}})");
    expect_same(std::get<ThinDielectricMaterial>(material_of(scene)).colour.curve(),
                Spectrum::rgb_albedo({0.2F, 0.4F, 0.6F}));
}

TEST_F(GltfMaterial, alpha_cuts_or_thins) {
    const auto cover = [&](const std::string& mode) {
        const SceneDescription scene =
            with(R"("pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.3]},"alphaMode":")" + mode);
        const Cover& of_shape = scene.shapes[0].placed.cover;
        return of_shape ? of_shape(Hit()) : 1;
    };
    EXPECT_EQ(cover(R"(OPAQUE")"), 1);
    EXPECT_EQ(cover(R"(BLEND")"), 0.3F);
    EXPECT_EQ(cover(R"(MASK")"), 0);
    EXPECT_EQ(cover(R"(MASK","alphaCutoff":0.3)"), 1);
    EXPECT_EQ(cover(R"(MASK","alphaCutoff":0)"), 1);
    EXPECT_EQ(cover(R"(MASK","alphaCutoff":1.5)"), 0) << "nothing is left";
    EXPECT_EQ(fault_of(scene_of(R"("alphaMode":"HALF")")),
              "scene.gltf: materials[0].alphaMode: is no mode of alpha; write OPAQUE, MASK or "
              "BLEND");
}

/// Two texels, of alpha 255 and 128: it is no light, and sRGB says nothing of it.
TEST_F(GltfMaterial, alpha_of_textures_is_linear) {
    const SceneDescription scene = read(
        R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"materials":[{"alphaMode":"BLEND",
"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
"textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)" +
        std::string(kTwoTexels) + R"("}],)" + textured_square_json(R"(,"material":0)"));
    Hit hit;
    hit.uv = Vec2(0.75F, 0.5F);
    EXPECT_NEAR(scene.shapes.at(0).placed.cover(hit), 128 / 255.0F, 1e-3F);
    hit.uv = Vec2(0.25F, 0.5F);
    EXPECT_EQ(scene.shapes[0].placed.cover(hit), 1);
}

/// The square has no texture coordinates: what the factor says counts alone, and emission too.
TEST_F(GltfMaterial, textures_without_coordinates_are_left_out) {
    const SceneDescription scene = with(
        R"("pbrMetallicRoughness":{"baseColorFactor":[0.5,0.5,0.5,1],"baseColorTexture":{"index":0}},
"emissiveFactor":[1,1,1],"emissiveTexture":{"index":0},"normalTexture":{"index":0}}],
"textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)" +
        std::string(kTwoTexels) + R"("}],"others":[{)");
    const auto& metal = std::get<ConductorMaterial>(material_of(scene));
    expect_same(metal.reflectance->curve(), Spectrum::rgb_albedo({0.5F, 0.5F, 0.5F}));
    EXPECT_FALSE(scene.shapes[0].emission->image);
    EXPECT_TRUE(is_flat(scene.bump_maps.at(scene.shapes[0].material)));
    EXPECT_TRUE(warns(scene,
                      "baseColorTexture: warning: asks for texture coordinates that its "
                      "mesh lacks: the texture is left out"));
}

/// 0 stands for an index without end: reflection is the colour of KHR_materials_specular alone.
TEST_F(GltfMaterial, an_index_of_zero_is_infinite) {
    const std::string begin =
        R"("pbrMetallicRoughness":{"metallicFactor":0},"extensions":{"KHR_materials_ior":{"ior":0})";
    const SceneDescription grey =
        with(begin + R"(,"KHR_materials_specular":{"specularColorFactor":[0.04,0.04,0.04]}})");
    const auto& plastic = std::get<CoatedDiffuseMaterial>(material_of(grey));
    EXPECT_NEAR(plastic.coat->reflectance(1), 0.04F, 1e-6F);
    const SceneDescription mirror = with(begin + "}");
    EXPECT_GT(std::get<CoatedDiffuseMaterial>(material_of(mirror)).coat->reflectance(1), 0.89F);
    const SceneDescription glass =
        with(begin + R"(,"KHR_materials_transmission":{"transmissionFactor":1}})");
    EXPECT_EQ(std::get<ThinDielectricMaterial>(material_of(glass)).eta(550), 1.5F);
    EXPECT_TRUE(warns(glass, "glass of an infinite index: 1.5 is taken"));
}

TEST_F(GltfMaterial, numbers_out_of_range_are_refused) {
    EXPECT_EQ(fault_of(scene_of(R"("pbrMetallicRoughness":{"metallicFactor":1.5})")),
              "scene.gltf: materials[0].pbrMetallicRoughness.metallicFactor: is out of range; "
              "write a number of 0.0 to 1.0");
    EXPECT_NE(fault_of(scene_of(R"("extensions":{"KHR_materials_ior":{"ior":0.5}})")), "");
    EXPECT_NE(fault_of(scene_of(R"("emissiveFactor":[1,1])")), "");
}

/// Both sides of a pane let light through, whatever the flag says.
TEST_F(GltfMaterial, two_sided_glass_is_glass) {
    for (const char* flag : {"true", "false"}) {
        const SceneDescription scene = read(
            R"("materials":[{"doubleSided":)" + std::string(flag) +
            R"(,"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0},
"extensions":{"KHR_materials_transmission":{"transmissionFactor":1}}}],)" +
            R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)" + square_json(R"(,"material":0)"));
        EXPECT_TRUE(std::holds_alternative<ThinDielectricMaterial>(
            scene.materials.at(scene.shapes.at(0).material)));
    }
}

/// The factor, the strength and the texture, each once.
TEST_F(GltfMaterial, emission_is_factor_times_strength_times_texture) {
    const SceneDescription scene = read(
        R"("materials":[{"emissiveFactor":[0.5,0.5,0.5],"emissiveTexture":{"index":0},
"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":683}}}],
"textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)"
        R"(iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mP4//8/AAX+Av4zEpUUAAAAAElFTkSuQmCC"}],
"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)" +
        textured_square_json(R"(,"material":0)"));
    const AreaEmission& emission = *scene.shapes.at(0).emission;
    ASSERT_TRUE(emission.image);
    const Scene built(scene);
    double power = 0;
    for (const Light& light : built.lights())
        power += std::visit([&](const auto& l) { return l.power(built.sphere()); }, light);
    EXPECT_NEAR(power, 0.5 * kPiDouble, 1e-3);
}

TEST_F(GltfMaterial, names_are_kept) {
    const auto named = [&](const std::string& material) {
        const SceneDescription scene = with(material);
        const std::uint32_t number = scene.shapes.at(0).material;
        return Scene(scene).names().materials.at(number);
    };
    EXPECT_EQ(named(R"("name":"felt")"), "felt");
    EXPECT_EQ(named(R"("name":"glass","extensions":{"KHR_materials_transmission":
{"transmissionFactor":1}})"),
              "glass");
    EXPECT_EQ(named("").find("material "), 0U);
}

}  // namespace
}  // namespace sunfleck::engine
