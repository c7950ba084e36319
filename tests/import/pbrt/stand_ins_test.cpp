// Hair, skin and measured materials: what stands in for them, and with which energy.
#include "import/pbrt/scene_text.h"
#include "import/pbrt/tensors.h"
#include "material/fibre_albedo.h"
#include "material/subsurface_albedo.h"

namespace sunfleck::engine {
namespace {

template <class M>
M made(const std::string& statement, const MemoryFiles& files = {}) {
    const SceneDescription scene = read_world(statement + " Shape \"sphere\"", files);
    EXPECT_EQ(warnings_with(scene, "is not simulated"), 1) << statement;
    return std::get<M>(scene.materials.at(1));
}

float at_500(const SpectrumTexture& texture) {
    return texture.curve()(500);
}

TEST(Hair, has_the_shares_of_a_fibre) {
    const auto hair = made<DiffuseTransmissionMaterial>(
        "Material \"hair\" \"spectrum sigma_a\" [200 .4 900 .4] \"float eta\" 1.4");
    const FibreAlbedo expected = fibre_albedo(0.4F, 1.4F);
    EXPECT_NEAR(at_500(hair.reflectance), expected.back, 1e-5F);
    EXPECT_NEAR(at_500(hair.transmittance), expected.through, 1e-5F);
}

TEST(Hair, is_told_its_colour_in_pbrts_ways) {
    const auto share = [](const std::string& parameters) {
        const auto hair = made<DiffuseTransmissionMaterial>(
            "Material \"hair\" \"float beta_n\" .2 " + parameters);
        return at_500(hair.reflectance) + at_500(hair.transmittance);
    };
    const auto expected = [](float absorption) {
        const FibreAlbedo albedo = fibre_albedo(absorption, 1.55F);
        return albedo.back + albedo.through;
    };
    EXPECT_NEAR(share("\"rgb color\" [.5 .5 .5]"), expected(absorption_of_hair(0.5F, 0.2F)), 1e-5);
    EXPECT_EQ(share("\"rgb reflectance\" [.5 .5 .5]"), share("\"rgb color\" [.5 .5 .5]"));
    EXPECT_NEAR(share("\"rgb reflectance\" [1 1 1]"), 1, 1e-5);
    EXPECT_EQ(share(""), share("\"float eumelanin\" 1.3"));
    const float red = Spectrum::rgb_unbounded({0.374F, 0.8F, 2.1F})(500);
    EXPECT_NEAR(share("\"float pheomelanin\" 2"), expected(red), 1e-4);
    EXPECT_LT(share("\"float eumelanin\" 8"), share("\"float eumelanin\" .3"));
}

TEST(Subsurface, has_the_reflectance_that_it_is_given) {
    const auto skin = made<CoatedDiffuseMaterial>(
        "Material \"subsurface\" \"rgb reflectance\" [.6 .6 .6] \"rgb mfp\" [ 1 1 1 ]");
    EXPECT_TRUE(skin.whole);
    EXPECT_FLOAT_EQ(at_500(skin.reflectance), 0.6F);
    EXPECT_EQ(skin.coat->eta(), 1.33F);
    EXPECT_EQ(skin.coat->attenuated(0.5F), 1);
    EXPECT_FALSE(skin.coat->facets());
}

TEST(Subsurface, has_the_reflectance_of_its_coefficients) {
    const auto made_of = [](const std::string& parameters) {
        return at_500(
            made<CoatedDiffuseMaterial>("Material \"subsurface\" " + parameters).reflectance);
    };
    EXPECT_NEAR(made_of("\"spectrum sigma_a\" [200 1 900 1] \"spectrum sigma_s\" [200 9 900 9]"),
                SubsurfaceAlbedo(1.33F, 0)(0.9F), 1e-5);
    EXPECT_NEAR(made_of("\"spectrum sigma_a\" [200 1 900 1] \"spectrum sigma_s\" [200 9 900 9] "
                        "\"float g\" .8 \"float eta\" 1.5"),
                SubsurfaceAlbedo(1.5F, 0.8F)(0.9F), 1e-5);
    EXPECT_GT(made_of(""), 0.8);  // milk
    EXPECT_GT(made_of("\"string name\" \"Wholemilk\""), made_of("\"string name\" \"Ketchup\""));
}

TEST(Subsurface, that_cannot_be_is_an_error) {
    const auto error = [](const std::string& parameters) {
        return world_error("Material \"subsurface\" " + parameters + " Shape \"sphere\"");
    };
    EXPECT_TRUE(contains(error("\"string name\" \"Wholmilk\""), "Wholemilk"));
    EXPECT_NE(error("\"rgb sigma_a\" [1 1 1]"), "");
    EXPECT_NE(error("\"float g\" 1"), "");
    EXPECT_NE(world_error("Material \"hair\" \"float eta\" 0 Shape \"sphere\""), "");
}

/// Two azimuths, three angles of incidence, two wavelengths, 3 x 3 numbers: `level` per wavelength,
/// and facets of GGX.
test::TensorFile measured(float first, float second, float alpha) {
    test::TensorFile file;
    file.add("theta_i", {3}, {0, 0.7F, 1.5F});
    file.add("phi_i", {2}, {0, 1});
    file.add("wavelengths", {2}, {400, 700});
    std::vector<float> spectra;
    for (int i = 0; i < 6; ++i) {
        spectra.insert(spectra.end(), 9, first);
        spectra.insert(spectra.end(), 9, second);
    }
    file.add("spectra", {2, 3, 2, 3, 3}, spectra);
    std::vector<float> facets;
    for (int row = 0; row < 2; ++row)
        for (int j = 0; j < 400; ++j) {
            const float u = static_cast<float>(j) / 399;
            const float c = std::cos(u * u * kPi / 2);
            const float base = c * c * (alpha * alpha - 1) + 1;
            facets.push_back(1 / (base * base));
        }
    file.add("ndf", {2, 400}, facets);
    return file;
}

const std::string kMeasured = "Material \"measured\" \"string filename\" \"x.bsdf\"";

TEST(Measured, is_metal_of_its_roughness_or_diffuse) {
    const auto gloss =
        made<ConductorMaterial>(kMeasured, {{"x.bsdf", measured(0.2F, 0.8F, 0.2F).bytes()}});
    EXPECT_NEAR((*gloss.reflectance).curve()(400), 0.2F, 1e-5F);
    EXPECT_NEAR((*gloss.reflectance).curve()(550), 0.5F, 1e-5F);
    EXPECT_NEAR(gloss.roughness.alphas({}).x, 0.2F, 0.01F);
    const auto chalk =
        made<DiffuseMaterial>(kMeasured, {{"x.bsdf", measured(0.2F, 0.8F, 0.9F).bytes()}});
    EXPECT_NEAR(at_500(chalk.reflectance), 0.4F, 1e-5F);
    const auto noise =
        made<DiffuseMaterial>(kMeasured, {{"x.bsdf", measured(1.7F, -0.1F, 0.9F).bytes()}});
    EXPECT_EQ(noise.reflectance.curve()(400), 1);
    EXPECT_EQ(noise.reflectance.curve()(700), 0);
}

/// Steeper angles of incidence count by their share of evenly spread light.
TEST(Measured, mean_is_over_evenly_spread_light) {
    test::TensorFile slanted;
    slanted.add("theta_i", {3}, {0, kPi / 6, kPi / 2});
    slanted.add("wavelengths", {1}, {500});
    slanted.add("spectra", {1, 3, 1, 1, 3}, {0.2F, 0.4F, 0.2F, 0.8F, 1, 0.8F, 0, 0, 0});
    slanted.add("ndf", {1, 3}, {1, 1, 1});
    const auto made_of = made<ConductorMaterial>(kMeasured, {{"x.bsdf", slanted.bytes()}});
    EXPECT_NEAR(at_500(*made_of.reflectance), 0.3F / 8 + 0.9F / 2, 1e-5F);
}

TEST(Measured, broken_files_are_errors) {
    const auto error = [](const std::string& bytes) {
        std::string text = world_error(kMeasured + " Shape \"sphere\"", {{"x.bsdf", bytes}});
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 0);
        return text;
    };
    EXPECT_NE(world_error(kMeasured + " Shape \"sphere\""), "");
    EXPECT_NE(world_error("Material \"measured\" Shape \"sphere\""), "");
    const std::string good = measured(0.2F, 0.8F, 0.2F).bytes();
    EXPECT_EQ(error(good), "");
    for (std::size_t size = 0; size < good.size(); size += size < 300 ? 1 : 97)
        EXPECT_NE(error(good.substr(0, size)), "") << size;
    EXPECT_TRUE(contains(error("no " + good), "begin"));
    test::TensorFile without = measured(0.2F, 0.8F, 0.2F);
    without.drop("ndf");
    EXPECT_TRUE(contains(error(without.bytes()), "\"ndf\""));
    test::TensorFile nan = measured(NAN, 0.8F, 0.2F);
    EXPECT_TRUE(contains(error(nan.bytes()), "finite"));
    test::TensorFile flat = measured(0.2F, 0.8F, 0.2F);
    flat.drop("theta_i");
    flat.add("theta_i", {2}, {0, 1});
    EXPECT_TRUE(contains(error(flat.bytes()), "another shape"));
    test::TensorFile falling = measured(0.2F, 0.8F, 0.2F);
    falling.drop("wavelengths");
    falling.add("wavelengths", {2}, {700, 400});
    EXPECT_NE(error(falling.bytes()), "");
    test::TensorFile vast = measured(0.2F, 0.8F, 0.2F);
    vast.drop("spectra");
    vast.add("spectra", {1ULL << 62U, 3, 2, 8, 8}, {1});
    EXPECT_TRUE(contains(error(vast.bytes()), "fit"));
}

}  // namespace
}  // namespace sunfleck::engine
