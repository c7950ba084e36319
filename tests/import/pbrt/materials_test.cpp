// Materials: ours by their parameters, the others by approximations.
#include "import/pbrt/materials.h"

#include "import/pbrt/scene_text.h"

namespace sunfleck::engine {
namespace {

template <class M>
M made(const std::string& statement) {
    const SceneDescription scene = read_world(statement + " Shape \"sphere\"");
    return std::get<M>(scene.materials.at(scene.shapes.at(0).material));
}

TEST(Materials, without_one_are_grey) {
    EXPECT_FLOAT_EQ(made<DiffuseMaterial>("").reflectance.curve()(500), 0.5F);
    EXPECT_FLOAT_EQ(made<DiffuseMaterial>("Material \"diffuse\"").reflectance.curve()(500), 0.5F);
}

TEST(Materials, dielectrics_have_an_index_and_roughness) {
    EXPECT_FLOAT_EQ(made<DielectricMaterial>("Material \"dielectric\"").eta(500), 1.5F);
    const auto glass = made<DielectricMaterial>(
        "Material \"dielectric\" \"float eta\" 1.33 \"float roughness\" .25 \"float vroughness\" "
        ".04");
    EXPECT_FLOAT_EQ(glass.eta(500), 1.33F);
    EXPECT_FLOAT_EQ(glass.roughness.alphas({}).x, 0.5F);
    EXPECT_FLOAT_EQ(glass.roughness.alphas({}).y, 0.2F);
    const auto bk7 = made<DielectricMaterial>(
        "Material \"dielectric\" \"spectrum eta\" "
        "\"glass-BK7\" \"bool remaproughness\" false "
        "\"float roughness\" .25");
    EXPECT_NEAR(bk7.eta(587.6F), 1.5168F, 1e-3F);
    EXPECT_FLOAT_EQ(bk7.roughness.alphas({}).x, 0.25F);
    EXPECT_FLOAT_EQ(
        made<ThinDielectricMaterial>("Material \"thindielectric\" \"float eta\" 1.4").eta(500),
        1.4F);
}

TEST(Materials, conductors_are_copper_unless_told) {
    const auto copper = made<ConductorMaterial>("Material \"conductor\"");
    EXPECT_EQ(copper.eta.curve()(500), (*named_spectrum("metal-Cu-eta"))(500));
    EXPECT_EQ(copper.k.curve()(500), (*named_spectrum("metal-Cu-k"))(500));
    const auto rgb =
        made<ConductorMaterial>("Material \"conductor\" \"rgb eta\" [ 2 2 2 ] \"rgb k\" [ 3 3 3 ]");
    EXPECT_FLOAT_EQ(rgb.eta.curve()(500), 2);
    EXPECT_FLOAT_EQ(rgb.k.curve()(500), 3);
    EXPECT_FALSE(rgb.reflectance);
    const auto mirror =
        made<ConductorMaterial>("Material \"conductor\" \"rgb reflectance\" [ .9 .9 .9 ]");
    EXPECT_FLOAT_EQ(mirror.reflectance->curve()(500), 0.9F);
}

TEST(Materials, interfaces_have_three_names) {
    for (const char* word : {"interface", "none", ""})
        made<InterfaceMaterial>("Material \"" + std::string(word) + "\"");
}

TEST(Materials, by_name_may_be_made_later) {
    const auto later = read_world(
        "NamedMaterial \"a\" Shape \"sphere\" Shape \"disk\" Material \"interface\" "
        "MakeNamedMaterial \"a\" \"rgb reflectance\" [ .2 .2 .2 ] \"string type\" "
        "\"diffuse\"");
    EXPECT_EQ(later.shapes[0].material, later.shapes[1].material);
    const auto& material = std::get<DiffuseMaterial>(later.materials[later.shapes[0].material]);
    EXPECT_FLOAT_EQ(material.reflectance.curve()(500), 0.2F);
}

TEST(Materials, coated_diffuse_has_a_coat) {
    const SceneDescription smooth = read_world(
        "Material \"coateddiffuse\" \"rgb reflectance\" [ .3 .3 .3 ] \"float roughness\" 0 "
        "\"integer nsamples\" 4 Shape \"sphere\"");
    const auto& plain = std::get<CoatedDiffuseMaterial>(smooth.materials.at(1));
    EXPECT_FLOAT_EQ(plain.reflectance.curve()(500), 0.3F);
    EXPECT_EQ(plain.coat->eta(), 1.5F);
    EXPECT_FALSE(plain.coat->facets());
    EXPECT_FALSE(plain.whole);
    EXPECT_TRUE(
        made<CoatedDiffuseMaterial>("Material \"coateddiffuse\" \"bool compensated\" true").whole);
    EXPECT_EQ(warnings_with(smooth, "coat"), 0);
    EXPECT_EQ(warnings_with(smooth, "unused"), 0);
    const auto rough = made<CoatedDiffuseMaterial>(
        "Material \"coateddiffuse\" \"float roughness\" .09 \"float vroughness\" .25 \"float "
        "eta\" 1.3 \"float thickness\" .5");
    EXPECT_FLOAT_EQ(rough.coat->facets()->alpha_x, 0.3F);
    EXPECT_FLOAT_EQ(rough.coat->facets()->alpha_y, 0.5F);
    EXPECT_EQ(rough.coat->eta(), 1.3F);
    EXPECT_NE(world_error("Material \"coateddiffuse\" \"float roughness\" -1 Shape \"sphere\""),
              "");
    EXPECT_NE(world_error("Material \"coateddiffuse\" \"float eta\" 0 Shape \"sphere\""), "");
    EXPECT_EQ(warnings_with(read_world("Material \"coateddiffuse\" \"rgb albedo\" [ .5 .5 .5 ] "
                                       "Shape \"sphere\""),
                            "albedo"),
              1);
}

TEST(Materials, coated_conductor_has_a_coat_over_metal) {
    const auto coated = made<CoatedConductorMaterial>(
        "Material \"coatedconductor\" \"spectrum conductor.eta\" \"metal-Au-eta\" \"spectrum "
        "conductor.k\" \"metal-Au-k\" \"float conductor.roughness\" .04 \"float "
        "interface.roughness\" .09 \"float interface.eta\" 1.4");
    EXPECT_EQ(coated.metal.k.curve()(500), (*named_spectrum("metal-Au-k"))(500));
    EXPECT_FLOAT_EQ(coated.metal.roughness.alphas({}).x, 0.2F);
    EXPECT_FLOAT_EQ(coated.coat->facets()->alpha_x, 0.3F);
    EXPECT_EQ(coated.coat->eta(), 1.4F);
}

TEST(Materials, diffuse_transmission_scales_both_parts) {
    const auto plain = made<DiffuseTransmissionMaterial>("Material \"diffusetransmission\"");
    EXPECT_FLOAT_EQ(plain.reflectance.curve()(500), 0.25F);
    const auto leaf = made<DiffuseTransmissionMaterial>(
        "Material \"diffusetransmission\" \"rgb transmittance\" [ .4 .4 .4 ] \"float scale\" .5");
    EXPECT_FLOAT_EQ(leaf.reflectance.curve()(500), 0.125F);
    EXPECT_FLOAT_EQ(leaf.transmittance.curve()(500), 0.2F);
}

TEST(Materials, mixes_have_two_parts) {
    const std::string two =
        "MakeNamedMaterial \"g\" \"string type\" \"dielectric\" "
        "MakeNamedMaterial \"d\" \"string type\" \"diffuse\" "
        "MakeNamedMaterial \"i\" \"string type\" \"interface\" ";
    const SceneDescription scene =
        read_world(two +
                   "Material \"mix\" \"string materials\" [ \"g\" \"d\" ] \"float amount\" .3 "
                   "Shape \"sphere\"");
    const auto& mix = std::get<MixMaterial>(scene.materials.at(1));
    EXPECT_TRUE(std::holds_alternative<DielectricMaterial>(scene.materials.at(mix.components[0])));
    EXPECT_TRUE(std::holds_alternative<DiffuseMaterial>(scene.materials.at(mix.components[1])));
    EXPECT_EQ(mix.amount.constant(), 0.3F);
    EXPECT_EQ(warnings_with(scene, "mix"), 0);
    const SceneDescription holes =
        read_world(two + "Material \"mix\" \"string materials\" [ \"i\" \"d\" ] Shape \"sphere\"");
    const auto& whole = std::get<MixMaterial>(holes.materials.at(1));
    EXPECT_EQ(whole.components[0], whole.components[1]);
    EXPECT_EQ(warnings_with(holes, "mix"), 1);
    EXPECT_NE(world_error(two + "Material \"mix\""), "");
    EXPECT_NE(world_error(two + "Material \"mix\" \"string materials\" [ \"x\" \"d\" ]"), "");
    EXPECT_TRUE(
        contains(world_error("MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string materials\" "
                             "[ \"m\" \"m\" ] NamedMaterial \"m\" Shape \"sphere\""),
                 "cycle"));
}

/// Looked at once each: as a tree these would be 2^30.
TEST(Materials, that_share_mixes_are_read_at_once) {
    std::string text = "MakeNamedMaterial \"m0\" \"string type\" \"diffuse\"\n";
    for (int i = 1; i <= 30; ++i) {
        const std::string below = "\"m" + std::to_string(i - 1) + "\" ";
        text += "MakeNamedMaterial \"m" + std::to_string(i) +
                "\" \"string type\" \"mix\" \"string materials\" [ " + below + below + "]\n";
    }
    EXPECT_EQ(world_error(text + "NamedMaterial \"m30\" Shape \"sphere\""), "");
}

TEST(Materials, take_defaults_of_their_block) {
    const SceneDescription scene = read_world(
        "AttributeBegin Attribute \"material\" \"rgb reflectance\" [ .2 .2 .2 ] \"float eta\" 2 "
        "Material \"diffuse\" Shape \"sphere\" AttributeEnd Material \"diffuse\" Shape \"sphere\"");
    EXPECT_FLOAT_EQ(std::get<DiffuseMaterial>(scene.materials.at(1)).reflectance.curve()(500),
                    0.2F);
    EXPECT_FLOAT_EQ(std::get<DiffuseMaterial>(scene.materials.at(2)).reflectance.curve()(500),
                    0.5F);
    EXPECT_EQ(warnings_with(scene, "unused"), 0);
}

TEST(Materials, that_cannot_be_are_errors) {
    for (const char* text :
         {"Material \"glas\"", "MakeNamedMaterial \"a\"",
          "MakeNamedMaterial \"a\" \"string type\" \"glas\"",
          R"(MakeNamedMaterial "a" "string type" "" MakeNamedMaterial "a" "string type" "")",
          "NamedMaterial \"a\" Shape \"sphere\"", "Material \"dielectric\" \"float eta\" 0",
          "Material \"dielectric\" \"float roughness\" -1",
          "Material \"conductor\" \"rgb eta\" [ 1 1 1 ] \"rgb reflectance\" [ 1 1 1 ]",
          "Material \"dielectric\" \"texture roughness\" \"x\""})
        EXPECT_NE(world_error(text), "") << text;
}

}  // namespace
}  // namespace sunfleck::engine
