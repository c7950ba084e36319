// Names of materials, as users write them.
#include "material/named_materials.h"

#include <gtest/gtest.h>

#include <set>

namespace sunfleck::engine {
namespace {

std::string fault_of(const std::string& text) {
    try {
        named_material(text, {"--material"});
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

const Spectrum& reflectance_of(const Material& material) {
    if (const auto* plastic = std::get_if<CoatedDiffuseMaterial>(&material))
        return plastic->reflectance.curve();
    return std::get<DiffuseMaterial>(material).reflectance.curve();
}

float reflectance_of(const std::string& text, float nm) {
    return reflectance_of(named_material(text, {"x"}).material)(nm);
}

float alpha_of(const std::string& text) {
    const Material material = named_material(text, {"x"}).material;
    if (const auto* glass = std::get_if<DielectricMaterial>(&material))
        return glass->roughness.u.constant();
    if (const auto* metal = std::get_if<ConductorMaterial>(&material))
        return metal->roughness.u.constant();
    const auto& facets = std::get<CoatedDiffuseMaterial>(material).coat->facets();
    return facets ? facets->alpha_x : 0;
}

/// All names differ, are as the grammar has them, and make something; those of light are clear.
TEST(NamedMaterial, is_made_of_each_name) {
    std::set<std::string_view> seen;
    for (const MaterialName& row : material_names()) {
        SCOPED_TRACE(std::string(row.name));
        EXPECT_TRUE(seen.insert(row.name).second);
        EXPECT_FALSE(row.source.empty());
        const std::string full = std::string(name_of(row.family)) + ":" + std::string(row.name);
        const NamedMaterial made = named_material(full, {"x"});
        EXPECT_EQ(made.is_clear, row.family == MaterialFamily::glass);
        EXPECT_EQ(made.material.index(), named_material(row.name, {"x"}).material.index());
        EXPECT_NO_THROW(bsdf_of(made.material, Wavelengths{}));
    }
}

TEST(NamedMaterial, is_found_by_family_alias_and_other_spelling) {
    const auto index = [](const std::string& text) {
        return std::get<DielectricMaterial>(named_material(text, {"x"}).material).eta(550);
    };
    EXPECT_EQ(index("glass"), index("bk7"));
    EXPECT_EQ(index("Glass:Fused_Silica"), index("quartz"));
    EXPECT_EQ(index("fused silica"), index("quartz"));
    EXPECT_EQ(alpha_of("metal"), alpha_of("aluminum"));
}

TEST(NamedMaterial, takes_a_roughness_and_a_colour) {
    EXPECT_EQ(alpha_of("gold"), 0);
    EXPECT_FLOAT_EQ(alpha_of("gold:0.2"), 0.04F);
    EXPECT_FLOAT_EQ(alpha_of("glass:bk7:.5"), 0.25F);
    EXPECT_FLOAT_EQ(alpha_of("plastic:red:0.1"), 0.01F);
    EXPECT_FLOAT_EQ(alpha_of("plastic:0.1:red"), 0.01F);
    EXPECT_GT(reflectance_of("plastic:red", 650), 5 * reflectance_of("plastic:red", 520));
    EXPECT_NEAR(reflectance_of("matt:#808080", 500), 0.2159F, 1e-3F);
    EXPECT_EQ(reflectance_of("paper:#FFFFFF", 500), 1);
    for (const std::string_view name : colour_names())
        EXPECT_EQ(fault_of("plastic:" + std::string(name)), "") << name;
}

TEST(NamedMaterial, that_is_unknown_gets_the_nearest_names) {
    EXPECT_EQ(
        fault_of("bk8"),
        "--material: there is no material \"bk8\"; use \"bk7\", \"f2\" or \"sf5\", or another "
        "of docs/reference/materials.md");
    EXPECT_NE(fault_of("glass:saphire").find("\"saphire\"; use \"sapphire\","), std::string::npos);
    EXPECT_NE(fault_of("coper").find("use \"copper\","), std::string::npos);
    EXPECT_NE(fault_of("").find("there is no material \"\""), std::string::npos);
    EXPECT_NE(fault_of(std::string(100000, 'x')), "");
}

TEST(NamedMaterial, refuses_what_it_has_not) {
    EXPECT_EQ(fault_of("metal:bk7"), "--material: \"bk7\" is no metal; write glass:bk7");
    EXPECT_EQ(fault_of("stone:bk7"),
              "--material: \"stone\" is no family of materials; use glass, metal, plastic or matt "
              "before the name, or nothing");
    EXPECT_EQ(fault_of("gold:2"), "--material: a roughness of 2; give a number from 0 to 1");
    EXPECT_EQ(fault_of("gold:nan"), "--material: a roughness of nan; give a number from 0 to 1");
    EXPECT_EQ(fault_of("gold:red"),
              "--material: gold has a colour of its own; leave it out, or use plastic");
    EXPECT_EQ(fault_of("plaster:0.3"),
              "--material: plaster has no roughness; leave it out, or use plastic");
    EXPECT_EQ(fault_of("gold:0.1:0.2"), "--material: two numbers for the roughness; give one");
    EXPECT_EQ(
        fault_of("plastic:#12345"),
        "--material: \"#12345\" is neither a roughness nor a colour; write a number from 0 to "
        "1, a colour such as red, or #rrggbb");
}

}  // namespace
}  // namespace sunfleck::engine
