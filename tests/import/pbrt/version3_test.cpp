// Scenes of pbrt-v3 are told as such by the first word that gives them away.
#include "import/pbrt/scene_text.h"

namespace sunfleck::engine {
namespace {

void expect_version3(const std::string& message, const std::string& word) {
    EXPECT_TRUE(contains(message, "pbrt-v3")) << word << ": " << message;
    EXPECT_TRUE(contains(message, "--upgrade")) << word << ": " << message;
    EXPECT_EQ(message.find("main.pbrt:2:"), 0U) << word << ": " << message;
}

TEST(Version3, is_told_before_the_world) {
    for (const char* statement :
         {"Film \"image\" \"string filename\" \"a.exr\"", "Camera \"environment\"",
          "Sampler \"02sequence\"", "Sampler \"lowdiscrepancy\"", "Sampler \"random\"",
          "Integrator \"directlighting\"", "Integrator \"whitted\"", "SurfaceIntegrator \"path\"",
          "Renderer \"sampler\"", "TransformTimes [0 1]"})
        expect_version3(error_of(std::string("# old\n") + statement + "\nWorldBegin"), statement);
}

TEST(Version3, is_told_within_the_world) {
    for (const char* statement : {"Material \"matte\"",
                                  "Material \"plastic\"",
                                  "Material \"uber\" \"color Kd\" [1 1 1]",
                                  "Material \"glass\"",
                                  "Material \"mirror\"",
                                  "Material \"metal\"",
                                  "Material \"substrate\"",
                                  "Material \"disney\"",
                                  "Material \"translucent\"",
                                  "MakeNamedMaterial \"m\" \"string type\" \"matte\"",
                                  "Material \"mix\" \"string namedmaterial1\" \"a\"",
                                  "Material \"diffuse\" \"color reflectance\" [1 1 1]",
                                  "Texture \"t\" \"color\" \"imagemap\"",
                                  "Texture \"t\" \"spectrum\" \"uv\"",
                                  "LightSource \"infinite\" \"string mapname\" \"a.exr\"",
                                  "LightSource \"infinite\" \"blackbody L\" [ 6500 1 ]",
                                  "Shape \"cone\"",
                                  "Shape \"heightfield\"",
                                  "AreaLightSource \"area\"",
                                  "MakeNamedMedium \"m\" \"string type\" \"heterogeneous\"",
                                  "WorldEnd"})
        expect_version3(world_error(statement), statement);
}

TEST(Version3, words_are_free_where_they_are_names) {
    EXPECT_EQ(world_error("MakeNamedMaterial \"glass\" \"string type\" \"dielectric\" "
                          "NamedMaterial \"glass\" Texture \"uv\" \"float\" \"constant\" "
                          "ObjectBegin \"cone\" Shape \"sphere\" ObjectEnd "
                          "ObjectInstance \"cone\""),
              "");
}

}  // namespace
}  // namespace sunfleck::engine
