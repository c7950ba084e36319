// Textures are read again as they were.
#include "export/textures.h"

#include "export/round_trip.h"

#include <half.h>

namespace sunfleck::engine {
namespace {

/// The reflectance of the first shape's material, which is diffuse.
const SpectrumTexture& reflectance_of(const SceneDescription& scene) {
    return std::get<DiffuseMaterial>(scene.materials.at(scene.shapes.at(0).material)).reflectance;
}

void expect_same_texture(const SceneDescription& first) {
    const SceneDescription second = again(first);
    const Wavelengths wavelengths = some_wavelengths();
    for (int i = 0; i < 60; ++i) {
        const auto t = static_cast<float>(i);
        TexturePoint point({0.31F * t - 5, 0.17F * t, 3 - 0.23F * t},
                           Vec3(1, 0.1F * t, 0.3F).normalized(), {0.117F * t, 0.071F * t});
        expect_near(reflectance_of(first).at(point, wavelengths),
                    reflectance_of(second).at(point, wavelengths), 1e-4F, std::to_string(i));
    }
}

void expect_same_texture(const std::string& texture) {
    SCOPED_TRACE(texture);
    expect_same_texture(read_world(R"(
Texture "a" "spectrum" "constant" "rgb value" [ 0.8 0.2 0.1 ]
Texture "n" "float" "wrinkled" "integer octaves" 3
AttributeBegin
Translate 0.3 0 1 Rotate 40 1 1 0 Scale 0.5 2 1
)" + texture + R"(
AttributeEnd
Material "diffuse" "texture reflectance" "t"
Shape "sphere"
)"));
}

TEST(ExportedTextures, of_all_kinds_are_the_same) {
    for (const char* text :
         {R"(Texture "t" "spectrum" "scale" "texture tex" "a" "texture scale" "n")",
          R"(Texture "t" "spectrum" "mix" "texture tex1" "a" "rgb tex2" [ 0.1 0.2 0.3 ]
             "texture amount" "n")",
          R"(Texture "t" "spectrum" "directionmix" "texture tex1" "a" "vector3 dir" [ 1 2 3 ])",
          R"(Texture "t" "spectrum" "checkerboard" "texture tex1" "a" "float uscale" 3
             "float vdelta" 0.3)",
          R"(Texture "t" "spectrum" "checkerboard" "integer dimension" 3 "texture tex1" "a")",
          R"(Texture "t" "spectrum" "checkerboard" "string mapping" "spherical")",
          R"(Texture "t" "spectrum" "dots" "string mapping" "cylindrical" "texture inside" "a")",
          R"(Texture "t" "spectrum" "dots" "string mapping" "planar" "vector3 v1" [ 1 1 0 ]
             "float udelta" 0.4 "float vdelta" 0.1)",
          R"(Texture "t" "spectrum" "bilerp" "rgb v00" [ 0.3 0.3 0.1 ] "rgb v11" [ 0 1 0.5 ])",
          R"(Texture "t" "spectrum" "marble" "float scale" 3 "float variation" 0.4)",
          R"(Texture "w" "float" "windy"
             Texture "t" "spectrum" "scale" "texture tex" "a" "texture scale" "w")",
          R"(Texture "f" "float" "fbm" "float roughness" 0.7
             Texture "t" "spectrum" "mix" "texture amount" "f")"})
        expect_same_texture(text);
}

/// A scene whose first surface is coloured by a picture.
SceneDescription with_picture(const SpectrumImageKind& kind) {
    SceneDescription scene = read_world("Material \"diffuse\" Shape \"sphere\"");
    scene.materials.at(scene.shapes.at(0).material) =
        DiffuseMaterial{SpectrumTexture(SpectrumKind{kind})};
    return scene;
}

SpectrumImageKind picture(Image::Texels texels, int channels, const Encoding& encoding = {}) {
    SpectrumImageKind kind;
    kind.image = std::make_shared<const Image>(Vec2i(3, 2), channels, std::move(texels), encoding);
    return kind;
}

const std::vector<std::uint8_t> kBytes = {10,  200, 90,  250, 30, 120, 0,  255, 77,
                                          140, 141, 142, 5,   60, 250, 99, 98,  1};

TEST(ExportedTextures, keep_pictures_of_all_depths) {
    std::vector<half> halves;
    std::vector<float> floats;
    for (const std::uint8_t byte : kBytes) {
        halves.emplace_back(static_cast<float>(byte) * 0.0037F);
        floats.push_back(static_cast<float>(byte) * 0.00371F);
    }
    expect_same_texture(with_picture(picture(kBytes, 3)));
    expect_same_texture(with_picture(picture(kBytes, 3, {Encoding::Kind::linear, 1})));
    expect_same_texture(with_picture(picture(kBytes, 3, {Encoding::Kind::gamma, 1.7F})));
    expect_same_texture(with_picture(picture(halves, 3)));
    expect_same_texture(with_picture(picture(floats, 3)));
    expect_same_texture(
        with_picture(picture(std::vector<std::uint8_t>(kBytes.begin(), kBytes.begin() + 6), 1)));
    std::vector<float> with_alpha(floats);
    with_alpha.insert(with_alpha.end(), floats.begin(), floats.begin() + 6);
    expect_same_texture(with_picture(picture(with_alpha, 4)));
}

TEST(ExportedTextures, keep_how_a_picture_lies_and_goes_on) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::black, Wrap::clamp, Wrap::mirror}) {
        SpectrumImageKind kind = picture(kBytes, 3);
        kind.wraps = wrap;
        kind.mapping = UvMapping{{1.7F, -0.8F}, {0.2F, 0.6F}};
        expect_same_texture(with_picture(kind));
    }
    SpectrumImageKind kind = picture(kBytes, 3);
    kind.nearest = true;
    kind.scale = 0.7F;
    kind.invert = true;
    kind.wraps = {Wrap::mirror, Wrap::repeat};
    expect_same_texture(with_picture(kind));
}

TEST(ExportedTextures, share_files) {
    SceneDescription scene = with_picture(picture(kBytes, 3));
    scene.shapes.push_back(scene.shapes.at(0));
    scene.materials.push_back(scene.materials.at(scene.shapes.at(0).material));
    scene.shapes.at(1).material = static_cast<std::uint32_t>(scene.materials.size() - 1);
    EXPECT_EQ(pbrt_scene(scene, "cup.pbrt").files.size(), 2U);
}

TEST(ExportedTextures, tell_what_is_not_said) {
    SpectrumImageKind kind = picture(kBytes, 3);
    kind.mapping = TurnedUvMapping{{0.8F, 0.6F}, {-0.6F, 0.8F}, {0, 0}};
    kind.wraps = {Wrap::clamp, Wrap::repeat};
    EXPECT_EQ(pbrt_scene(with_picture(kind), "cup.pbrt").warnings.entries().size(), 2U);
}

}  // namespace
}  // namespace sunfleck::engine
