// Whole scenes are read again as they were.
#include "export/pbrt_scene.h"

#include "export/round_trip.h"

namespace sunfleck::engine {
namespace {

constexpr const char* kView = R"(
Scale -1 1 1
LookAt 0.3 1.5 -6  0 0 0  0 1 0
Camera "perspective" "float fov" 40
Film "rgb" "integer xresolution" 64 "integer yresolution" 48
WorldBegin
)";

TEST(PbrtScene, has_each_shape_in_its_place) {
    EXPECT_GT(expect_same_again(std::string(kView) + R"(
AttributeBegin Translate -1.5 0 0 Rotate 33 1 2 3 Shape "sphere" "float radius" 0.6 AttributeEnd
AttributeBegin Scale 1 1 -1 Shape "sphere" "float radius" 0.4 "float zmin" -0.2 "float phimax" 300
AttributeEnd
AttributeBegin Translate 1 0 0 ReverseOrientation Shape "cylinder" "float radius" 0.3 AttributeEnd
AttributeBegin Translate 0 -1 0 Rotate 90 1 0 0
Shape "disk" "float radius" 3 "float innerradius" 0.1 "float height" 0.2 AttributeEnd
Shape "bilinearmesh" "point3 P" [ -2 1 0  -1 1 0  -2 2 0.3  -1 2 0 ]
Shape "trianglemesh" "point3 P" [ 1 1 0  2 1 0  1 2 0.1 ] "normal N" [ 0 0 -1  0.1 0 -1  0 0 -1 ]
    "point2 uv" [ 0 0  1 0  0.2 1 ] "vector3 S" [ 1 0 0  1 0.1 0  1 0 0 ]
Shape "curve" "point3 P" [ -1 -1 -1  0 1 -1  1 -1 -1  1 1 -1 ] "float width" 0.2
Shape "curve" "string type" "cylinder" "point3 P" [ -1 0 -1  0 1 -1  1 0 -1  1 1 -1 ]
    "float width0" 0.1 "float width1" 0.3
)"),
              60);
}

TEST(PbrtScene, writes_large_meshes_as_files_bit_by_bit) {
    std::string points;
    std::string indices;
    for (int i = 0; i < 70; ++i) {
        points += std::to_string(i * 0.01 - 1) + " -0.7 0.3  " + std::to_string(i * 0.013) +
                  " 0.33 0.1  0.2 " + std::to_string(1 + i * 0.01) + " 0.7 ";
        indices += std::to_string(3 * i) + ' ' + std::to_string(3 * i + 1) + ' ' +
                   std::to_string(3 * i + 2) + ' ';
    }
    const SceneDescription first = read_world("Shape \"trianglemesh\" \"point3 P\" [" + points +
                                              "] \"integer indices\" [" + indices + "]");
    const ExportedScene exported = pbrt_scene(first, "cup.pbrt");
    ASSERT_EQ(exported.files.size(), 2U);
    EXPECT_EQ(exported.files[0].name, "cup-files/mesh-1.ply");
    const SceneDescription second = again(first);
    const auto& before = std::get<TriangleMesh>(first.shapes.at(0).placed.shape);
    const auto& after = std::get<TriangleMesh>(second.shapes.at(0).placed.shape);
    EXPECT_EQ(after.positions, before.positions);
    EXPECT_EQ(after.triangles, before.triangles);
}

TEST(PbrtScene, says_what_media_emit) {
    for (const char* light : {"\"rgb Le\" [3 2 1] \"float Lescale\" 2 ", "\"blackbody Le\" 3000 ",
                              "\"spectrum Le\" [400 1 700 5] \"float Lescale\" 4 "}) {
        const SceneDescription first =
            read_world("MakeNamedMedium \"fire\" \"string type\" \"homogeneous\" " +
                       std::string(light) + "MediumInterface \"fire\" \"\" Shape \"sphere\" ");
        const auto glow = again(first).media.all.at(1).glow;
        ASSERT_NE(glow, nullptr) << light;
        expect_near(first.media.all.at(1).glow->radiance.at(some_wavelengths()),
                    glow->radiance.at(some_wavelengths()), 1e-3F, light);
    }
    const SceneDescription varied = read_world(
        "MakeNamedMedium \"fire\" \"string type\" \"uniformgrid\" \"integer nx\" 2 "
        "\"float density\" [1 3] \"float temperature\" [2000 3000] "
        "MediumInterface \"fire\" \"\" Shape \"sphere\" ");
    const Warnings said = pbrt_scene(varied, "cup.pbrt").warnings;
    EXPECT_TRUE(std::any_of(said.entries().begin(), said.entries().end(), [](const auto& entry) {
        return contains(entry.text, "emits by place");
    }));
}

TEST(PbrtScene, has_objects_once_and_their_instances) {
    const std::string text = std::string(kView) + R"(
ObjectBegin "ball"
AttributeBegin Translate 0 0.2 0 Scale 1 0.7 1 Shape "sphere" "float radius" 0.5 AttributeEnd
Shape "disk" "float radius" 0.7
ObjectEnd
AttributeBegin Translate -1 0 0 ObjectInstance "ball" AttributeEnd
AttributeBegin Translate 1 0 0 Rotate 30 0 1 0 Scale -1 1 1 ObjectInstance "ball" AttributeEnd
)";
    EXPECT_GT(expect_same_again(text), 20);
    const std::string written = text_of(read_text(text));
    EXPECT_EQ(written.find("ObjectBegin"), written.rfind("ObjectBegin"));
}

TEST(PbrtScene, keeps_what_stands_between_media) {
    const SceneDescription first = read_text(R"(
MakeNamedMedium "tea" "string type" "homogeneous" "rgb sigma_a" [ 1 2 4 ] "rgb sigma_s" [ 0 0 0 ]
MakeNamedMedium "fog" "string type" "homogeneous" "spectrum sigma_a" [ 400 0.1 700 0.2 ]
    "rgb sigma_s" [ 0 0 0 ]
MediumInterface "" "fog"
Camera "perspective"
WorldBegin
Material "dielectric"
MediumInterface "tea" "fog"
Shape "sphere"
LightSource "point"
MediumInterface "" ""
Shape "disk"
)");
    const SceneDescription second = again(first);
    const auto sigma = [](const SceneDescription& scene, MediumNumber number) {
        return scene.media.all.at(number).absorption(520);
    };
    EXPECT_FLOAT_EQ(sigma(second, second.media.at_camera), sigma(first, first.media.at_camera));
    ASSERT_EQ(second.shapes.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        const MediumSides& before = first.shapes[i].media;
        const MediumSides& after = second.shapes[i].media;
        EXPECT_FLOAT_EQ(sigma(second, after.inside), sigma(first, before.inside));
        EXPECT_FLOAT_EQ(sigma(second, after.outside), sigma(first, before.outside));
    }
    EXPECT_FLOAT_EQ(sigma(second, second.media.at_lights.at(0).outside),
                    sigma(first, first.media.at_lights.at(0).outside));
}

TEST(PbrtScene, keeps_alpha_and_lights_that_are_not_seen) {
    const SceneDescription first = read_world(R"(
Texture "holes" "float" "checkerboard" "float uscale" 4 "float vscale" 4
Shape "sphere" "texture alpha" "holes"
Shape "disk" "float alpha" 0.3
AreaLightSource "diffuse" "rgb L" [ 2 3 4 ]
Shape "disk" "float alpha" 0
)");
    const SceneDescription second = again(first);
    ASSERT_EQ(second.shapes.size(), 3U);
    for (std::size_t i = 0; i < 2; ++i)
        for (const float u : {0.1F, 0.4F, 0.6F, 0.9F}) {
            Hit hit{};
            hit.uv = {u, 0.3F};
            EXPECT_EQ(second.shapes[i].placed.cover(hit), first.shapes[i].placed.cover(hit)) << u;
        }
    EXPECT_TRUE(second.shapes[2].unseen);
    EXPECT_TRUE(second.shapes[2].emission.has_value());
}

TEST(PbrtScene, writes_a_mask_without_a_texture_as_a_picture) {
    SceneDescription first = read_world("Shape \"disk\"");
    first.shapes.at(0).placed.cover = [](const Hit& hit) { return hit.uv.x < 0.5F ? 1.0F : 0.0F; };
    const ExportedScene exported = pbrt_scene(first, "cup.pbrt");
    EXPECT_EQ(exported.warnings.entries().size(), 1U);
    const SceneDescription second = again(first);
    Hit hit{};
    hit.uv = {0.4F, 0.9F};
    EXPECT_EQ(second.shapes.at(0).placed.cover(hit), 1);
    hit.uv = {0.6F, 0.1F};
    EXPECT_EQ(second.shapes.at(0).placed.cover(hit), 0);
}

TEST(PbrtScene, tells_each_thing_that_is_lost_once) {
    SceneDescription scene = read_world("Shape \"disk\" Shape \"disk\"");
    const SpectrumTexture red(Spectrum::rgb_albedo(Vec3(1, 0.2F, 0.1F)));
    scene.materials.assign(2, ThinDielectricMaterial{Spectrum::constant(1.5F), red});
    scene.shapes[1].material = 1;
    const auto entries = pbrt_scene(scene, "cup.pbrt").warnings.entries();
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_TRUE(contains(entries[0].text, "colour"));
    EXPECT_EQ(entries[0].count, 2);
}

}  // namespace
}  // namespace sunfleck::engine
