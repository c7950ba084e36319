// Materials are read again as they were.
#include "export/materials.h"

#include "export/round_trip.h"
#include "material/bump_map.h"
#include "math/warp.h"

namespace sunfleck::engine {
namespace {

/// The Bsdf of the material of a scene's first shape.
std::optional<Bsdf> first_bsdf(const SceneDescription& scene) {
    return bsdf_of(scene.materials.at(scene.shapes.at(0).material), some_wavelengths());
}

void expect_same_material(const std::string& text) {
    SCOPED_TRACE(text);
    const SceneDescription first = read_world(text + "\nShape \"sphere\"");
    const SceneDescription second = again(first);
    EXPECT_EQ(name_of(second.materials.at(second.shapes.at(0).material)),
              name_of(first.materials.at(first.shapes.at(0).material)));
    const auto a = first_bsdf(first);
    const auto b = first_bsdf(second);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (a) expect_same(*a, *b);
}

TEST(ExportedMaterials, keep_their_numbers) {
    for (const char* text :
         {R"(Material "diffuse" "rgb reflectance" [ 0.63 0.065 0.05 ])",
          R"(Material "diffuse" "spectrum reflectance" [ 300 0.1 500 0.9 900 0.2 ])",
          R"(Material "dielectric" "float eta" 1.33)",
          R"(Material "dielectric" "spectrum eta" "glass-BK7" "float roughness" 0.2)",
          R"(Material "dielectric" "float uroughness" 0.1 "float vroughness" 0.3
             "bool remaproughness" false)",
          R"(Material "thindielectric" "float eta" 1.4)",
          R"(Material "conductor" "spectrum eta" "metal-Au-eta" "spectrum k" "metal-Au-k")",
          R"(Material "conductor" "rgb reflectance" [ 0.9 0.7 0.3 ] "float roughness" 0.1)",
          R"(Material "conductor" "rgb eta" [ 0.2 0.9 1.4 ] "rgb k" [ 3 2.5 2 ])",
          R"(Material "coateddiffuse" "rgb reflectance" [ 0.2 0.5 0.8 ] "float roughness" 0.3
             "float thickness" 0.02 "float eta" 1.6)",
          R"(Material "coatedconductor" "float interface.roughness" 0.2
             "float conductor.roughness" 0.3 "bool remaproughness" true)",
          R"(Material "coatedconductor" "rgb reflectance" [ 0.9 0.5 0.2 ]
             "float interface.uroughness" 0.1 "float interface.vroughness" 0.2
             "float conductor.roughness" 0.3 "bool remaproughness" false)",
          R"(Material "diffusetransmission" "rgb reflectance" [ 0.3 0.2 0.1 ]
             "float scale" 0.7)",
          R"(Material "interface")"})
        expect_same_material(text);
}

TEST(ExportedMaterials, of_mixes_come_before_them) {
    const std::string text = R"(
MakeNamedMaterial "outer" "string type" "mix" "string materials" [ "inner" "red" ]
    "float amount" 0.3
MakeNamedMaterial "inner" "string type" "mix" "string materials" [ "red" "glass" ]
MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [ 1 0 0 ]
MakeNamedMaterial "glass" "string type" "dielectric"
NamedMaterial "outer"
Shape "sphere"
)";
    const SceneDescription first = read_world(text);
    const SceneDescription second = again(first);
    const auto& before = std::get<MixMaterial>(first.materials.at(first.shapes[0].material));
    const auto& after = std::get<MixMaterial>(second.materials.at(second.shapes[0].material));
    EXPECT_EQ(after.amount.constant(), before.amount.constant());
    EXPECT_TRUE(std::holds_alternative<MixMaterial>(second.materials.at(after.components[0])));
    const std::string written = text_of(first);
    std::string last;
    for (const char* type : {"\"mix\"", "\"diffuse\"", "\"dielectric\""})
        EXPECT_NE(written.find(type), std::string::npos);
    EXPECT_GT(written.rfind("\"mix\""), written.find("\"dielectric\""));
    EXPECT_GT(written.find("\"mix\""), written.find("\"diffuse\""));
}

TEST(ExportedMaterials, of_whole_coats_have_bases_that_send_as_much_out) {
    SceneDescription first = read_world("Material \"coateddiffuse\" Shape \"sphere\"");
    CoatedDiffuseMaterial plastic;
    plastic.coat = std::make_shared<const Coat>(1.5F, std::nullopt, 0.0F);
    plastic.whole = true;
    for (const Vec3& rgb : {Vec3(0.6F), Vec3(0.8F, 0.3F, 0.1F)}) {
        plastic.reflectance = Spectrum::rgb_albedo(rgb);
        first.materials.at(first.shapes.at(0).material) = plastic;
        expect_same(*first_bsdf(first), *first_bsdf(again(first)), 1e-3F);
    }
}

/// Share of diffuse light that a surface reflects.
double reflected(const Bsdf& bsdf) {
    constexpr int kSide = 12;
    double sum = 0;
    const auto place = [](int i) { return (static_cast<float>(i) + 0.5F) / kSide; };
    for (int k = 0; k < kSide; ++k)
        for (int j = 0; j < kSide; ++j)
            for (int i = 0; i < kSide; ++i) {
                const Vec3 wo(cosine_hemisphere(Vec2d(Vec2(place(k), place(5 * k % kSide)))));
                const Vec3 u(place((i + 5 * j + 3 * k) % kSide), place(i), place(j));
                const auto drawn = sample(bsdf, wo, {u, Transport::radiance, {}});
                if (drawn) sum += static_cast<double>(drawn->weight.mean());
            }
    return sum / (kSide * kSide * kSide);
}

TEST(ExportedMaterials, of_bright_rough_plastic_reflect_as_much) {
    SceneDescription first = read_world("Material \"coateddiffuse\" Shape \"sphere\"");
    CoatedDiffuseMaterial plastic;
    plastic.coat = std::make_shared<const Coat>(1.5F, Ggx{0.8F, 0.8F}, 0.0F);
    plastic.whole = true;
    for (const float grey : {0.3F, 0.95F}) {
        plastic.reflectance = Spectrum::constant(grey);
        first.materials.at(first.shapes.at(0).material) = plastic;
        const SceneDescription second = again(first);
        EXPECT_EQ(name_of(second.materials.at(second.shapes.at(0).material)),
                  grey > 0.5F ? "diffuse" : "coateddiffuse");
        const double wanted = reflected(*first_bsdf(first));
        EXPECT_NEAR(reflected(*first_bsdf(second)), wanted, 0.02 * wanted) << grey;
    }
}

TEST(ExportedMaterials, of_films_have_their_colour_along_the_normal) {
    SceneDescription first = read_world("Material \"conductor\" Shape \"sphere\"");
    IridescentConductorMaterial soap;
    soap.metal.reflectance = Spectrum::rgb_albedo({0.9F, 0.7F, 0.5F});
    soap.metal.roughness = {0.2F, 0.2F};
    soap.thickness = 400;
    first.materials.at(first.shapes.at(0).material) = soap;
    const Vec3 up(0, 0, 1);
    const SampledSpectrum wanted = eval(*first_bsdf(first), up, up, Transport::radiance);
    expect_near(wanted, eval(*first_bsdf(again(first)), up, up, Transport::radiance), 1e-3F,
                "value");
}

TEST(ExportedMaterials, keep_bumps_and_normal_maps) {
    const SceneDescription first = read_world(R"(
Texture "waves" "float" "fbm"
Material "diffuse" "texture displacement" "waves"
Shape "sphere"
)");
    const SceneDescription second = again(first);
    EXPECT_TRUE(
        std::holds_alternative<DisplacementMap>(second.bump_maps.at(second.shapes.at(0).material)));

    SceneDescription mapped = first;
    const auto image = std::make_shared<const Image>(
        Vec2i(2, 1), 3, std::vector<std::uint8_t>{128, 128, 255, 200, 100, 220},
        Encoding{Encoding::Kind::linear, 1});
    NormalMap map{image};
    map.strength = 0.5F;
    mapped.bump_maps.at(mapped.shapes.at(0).material) = map;
    const SceneDescription read = again(mapped);
    const auto& after = std::get<NormalMap>(read.bump_maps.at(read.shapes.at(0).material));
    const Vec3 wanted = image->rgb(1, 0);
    const Vec3 got = after.image->rgb(1, 0);
    EXPECT_NEAR(got.x - 0.5F, (wanted.x - 0.5F) * 0.5F, 1e-6F);
    EXPECT_NEAR(got.z, wanted.z, 1e-6F);
}

}  // namespace
}  // namespace sunfleck::engine
