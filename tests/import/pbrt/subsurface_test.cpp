// Subsurface scattering that is walked: a dielectric, full of a medium.
#include "import/pbrt/subsurface.h"

#include "import/pbrt/scene_text.h"
#include "material/subsurface_albedo.h"

namespace sunfleck::engine {
namespace {

SceneDescription walked(const std::string& text) {
    ImportSettings settings;
    settings.subsurface = SubsurfaceRule::walked;
    return read_pbrt_text("WorldBegin\n" + text, "main.pbrt", memory_access({}), settings);
}

const Medium& medium_in(const SceneDescription& scene, const ShapeDescription& shape) {
    return scene.media.all.at(shape.media.inside);
}

TEST(WalkedSubsurface, is_a_dielectric_full_of_its_coefficients) {
    const SceneDescription scene = walked(
        "Material \"subsurface\" \"spectrum sigma_a\" [200 1 900 1] \"float scale\" 3 "
        "\"spectrum sigma_s\" [200 9 900 9] \"float g\" .4 \"float eta\" 1.5 Shape \"sphere\" "
        "Material \"diffuse\" Shape \"sphere\"");
    EXPECT_TRUE(scene.warnings.entries().empty());
    const ShapeDescription& shape = scene.shapes.at(0);
    const auto& surface = std::get<DielectricMaterial>(scene.materials.at(shape.material));
    EXPECT_FLOAT_EQ(surface.eta(500), 1.5F);
    const Medium& medium = medium_in(scene, shape);
    EXPECT_FLOAT_EQ(medium.absorption(500), 3);
    EXPECT_FLOAT_EQ(medium.scattering(500), 27);
    EXPECT_FLOAT_EQ(medium.g, 0.4F);
    EXPECT_EQ(scene.shapes.at(1).media.inside, 0U);
}

TEST(WalkedSubsurface, has_the_reflectance_that_it_is_given_and_its_free_path) {
    const SceneDescription scene = walked(
        "Material \"subsurface\" \"spectrum reflectance\" [200 .7 900 .7] \"float scale\" 2 "
        "\"spectrum mfp\" [200 .25 900 .25] \"float roughness\" .3 Shape \"sphere\"");
    const ShapeDescription& shape = scene.shapes.at(0);
    const Medium& medium = medium_in(scene, shape);
    const float events = medium.absorption(500) + medium.scattering(500);
    EXPECT_NEAR(events, 2, 1e-4F);
    EXPECT_NEAR(SubsurfaceAlbedo(1.33F, 0)(medium.scattering(500) / events), 0.7F, 1e-3F);
    const auto& surface = std::get<DielectricMaterial>(scene.materials.at(shape.material));
    EXPECT_FALSE(surface.roughness.remap);
    EXPECT_GT(surface.roughness.u.constant(), 0.1F);
}

TEST(WalkedSubsurface, fills_objects_and_mixes_and_replaces_what_was_inside) {
    const std::string skin = "MakeNamedMaterial \"skin\" \"string type\" \"subsurface\" ";
    const SceneDescription scene = walked(
        "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" "
        "MediumInterface \"fog\" \"fog\" " +
        skin +
        "MakeNamedMaterial \"dirt\" \"string type\" \"diffuse\" "
        "MakeNamedMaterial \"dirty\" \"string type\" \"mix\" "
        "\"string materials\" [\"dirt\" \"skin\"] \"float amount\" .5 "
        "NamedMaterial \"dirty\" Shape \"sphere\" "
        "ObjectBegin \"arm\" NamedMaterial \"skin\" Shape \"sphere\" ObjectEnd "
        "ObjectInstance \"arm\"");
    EXPECT_EQ(scene.shapes.at(0).media, (MediumSides{2, 1}));
    EXPECT_EQ(scene.objects.at(0).at(0).media, (MediumSides{2, 1}));
    EXPECT_GT(scene.media.all.at(2).scattering(500), 2);  // milk
}

TEST(WalkedSubsurface, needs_a_positive_scale) {
    EXPECT_THROW(walked("Material \"subsurface\" \"float scale\" 0 Shape \"sphere\""), Error);
}

}  // namespace
}  // namespace sunfleck::engine
