// Spectra are read again within the stated error.
#include "export/spectra.h"

#include "export/round_trip.h"

namespace sunfleck::engine {
namespace {

Spectrum read_emission(const std::string& parameters) {
    const SceneDescription scene = read_world("LightSource \"point\" " + parameters);
    return std::get<PointLight>(scene.lights.at(0)).curve;
}

float greatest(const Spectrum& curve) {
    float most = 0;
    for (int nm = 360; nm <= 830; ++nm) most = std::max(most, curve(static_cast<float>(nm)));
    return most;
}

void expect_same_curve(const Spectrum& got, const Spectrum& wanted, float error) {
    for (float nm = 360; nm <= 830; nm += 0.7F)
        ASSERT_NEAR(got(nm), wanted(nm), error * greatest(wanted)) << nm;
}

TEST(ExportedSpectra, of_lights_are_the_same) {
    for (const char* text :
         {R"("rgb I" [ 17 12 4 ])", R"("rgb I" [ 3 3 3 ] "float scale" 0.7)", R"("float scale" 2)",
          R"("blackbody I" 3200 "float scale" 5)", R"("spectrum I" [ 300 1 900 1 ])",
          R"("spectrum I" "stdillum-F2" "float power" 60)",
          R"("spectrum I" [ 400 1 500 0 600 7.123456 ])",
          R"("rgb I" [ 0.123456789 0.00031 0.7 ] "float scale" 1e5)"}) {
        SCOPED_TRACE(text);
        const Spectrum wanted = read_emission(text);
        StatementText statement("", "");
        add_emission(statement, "I", wanted);
        const std::string& written = statement.text();
        expect_same_curve(read_emission(written.substr(written.find('\n'))), wanted, 3e-5F);
    }
}

TEST(ExportedSpectra, have_the_colours_that_were_given) {
    const auto text_of_albedo = [](const Vec3& rgb) {
        StatementText statement("", "");
        add_spectrum(statement, "r", Spectrum::rgb_albedo(rgb), ColourUse::albedo);
        return statement.text();
    };
    EXPECT_TRUE(contains(text_of_albedo({0.63F, 0.065F, 0.05F}), "\"rgb r\" [ 0.63 0.065 0.05 ]"));
    EXPECT_TRUE(contains(text_of_albedo({0.2F, 0.2F, 0.2F}), "\"rgb r\" [ 0.2 0.2 0.2 ]"));
}

TEST(ExportedSpectra, are_tables_where_no_colour_is_known) {
    const Spectrum wanted = Spectrum::rgb_unbounded({3, 0.4F, 0.1F}).scaled(0.1F);
    StatementText statement("", "");
    add_spectrum(statement, "reflectance", wanted, ColourUse::albedo);
    EXPECT_TRUE(contains(statement.text(), "\"spectrum reflectance\""));
    const std::string& written = statement.text();
    const SceneDescription scene = read_world(
        "Material \"diffuse\" " + written.substr(written.find('\n')) + "Shape \"sphere\"");
    const auto& material =
        std::get<DiffuseMaterial>(scene.materials.at(scene.shapes.at(0).material));
    expect_same_curve(material.reflectance.curve(), wanted, 3e-5F);
}

TEST(ExportedSpectra, need_few_points) {
    const Spectrum line = sparse_table([](float nm) { return nm; });
    EXPECT_EQ(std::get<TabulatedSpectrum>(line.kind()).points->size(), 2U);
}

}  // namespace
}  // namespace sunfleck::engine
