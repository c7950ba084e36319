// Textures: images from all places, samplers, transforms.
#include "import/gltf/textures.h"

#include "gltf_files.h"
#include "image/png.h"

namespace sunfleck::engine {
namespace {

using testing_support::base64;
using testing_support::warns;

class GltfTexture : public testing_support::GltfFiles {
protected:
    /// Writes a PNG of 2 x 1 pixels: red, then a dark green.
    std::string png() const {
        Picture picture{2, 1, {}, {}};
        picture.add("R").values = {1, 0};
        picture.add("G").values = {0, 0.25F};
        picture.add("B").values = {0, 0};
        write_png(path("a.png"), picture);
        std::ifstream in(path("a.png"), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    /// Returns what a texture of the first image is. @param info  more members of its textureInfo.
    GltfTextures::Slot slot(const std::string& image, TexelUse use, const std::string& info = "",
                            const std::string& sampler = "") {
        GltfDocument document(gltf(R"("images":[{)" + image + R"(}],"samplers":[{)" + sampler +
                                   R"(}],"textures":[{"source":0,"sampler":0}],
"holder":{"texture":{"index":0)" + info +
                                   "}}"));
        GltfTextures textures(document, warnings_);
        return *textures.find(document.root().at("holder"), "texture", use, vertices_);
    }
    /// Returns the colour at a place of a mesh whose v goes up.
    static Vec3 at(const GltfTextures::Slot& slot, const Vec2& uv) {
        return image_rgb(slot.image, TexturePoint(Vec3(0), Vec3(0, 0, 1), uv));
    }

    Warnings warnings_;
    GltfVertices vertices_;
};

TEST_F(GltfTexture, comes_from_files_and_data) {
    const std::string bytes = png();
    const std::string data = R"("uri":"data:image/png;base64,)" + base64(bytes) + '"';
    for (const std::string& image : {std::string(R"("uri":"a.png")"), data}) {
        const auto colour = slot(image, TexelUse::colour);
        EXPECT_LT((at(colour, {0.25F, 0.5F}) - Vec3(1, 0, 0)).length(), 1e-3F);
        EXPECT_NEAR(at(colour, {0.75F, 0.5F}).y, 0.25F, 5e-3F) << "sRGB";
        const auto stored = slot(image, TexelUse::green);
        EXPECT_NEAR(at(stored, {0.75F, 0.5F}).x, 0.537F, 5e-3F) << "as stored";
    }
}

TEST_F(GltfTexture, samplers_say_what_lies_beyond_the_edges) {
    png();
    const std::string image = R"("uri":"a.png")";
    const auto red_at = [&](float u, const std::string& sampler) {
        return at(slot(image, TexelUse::colour, "", sampler), {u, 0.5F}).x;
    };
    EXPECT_GT(red_at(1.25F, ""), 0.9F) << "repeats unless told";
    EXPECT_LT(red_at(1.25F, R"("wrapS":33071)"), 0.1F) << "clamps";
    EXPECT_LT(red_at(1.25F, R"("wrapS":33648)"), 0.1F) << "mirrors";
    EXPECT_GT(red_at(1.75F, R"("wrapS":33648)"), 0.9F);
    EXPECT_GT(red_at(1.25F, R"("wrapT":33071)"), 0.9F) << "the other axis";
    EXPECT_EQ(red_at(0.45F, R"("magFilter":9728)"), 1) << "the nearest texel";
}

/// By the extension's formula, in its own v: scaled, turned counter-clockwise, moved.
TEST_F(GltfTexture, transforms_scale_turn_and_move) {
    png();
    vertices_.own_set = 1;
    const auto turned = slot(R"("uri":"a.png")", TexelUse::colour,
                             R"(,"extensions":{"KHR_texture_transform":{"offset":[0.1,0.2],
"rotation":1.5707963267948966,"scale":[2,3],"texCoord":1}})");
    const Vec2 uv(0.3F, 0.4F);  // v down
    const Vec2 wanted(0.1F + 3 * uv.y, 0.2F - 2 * uv.x);
    const Vec2 found =
        place(turned.image.mapping, TexturePoint(Vec3(0), Vec3(0, 0, 1), {uv.x, 1 - uv.y}));
    EXPECT_NEAR(found.x, wanted.x, 1e-6F);
    EXPECT_NEAR(1 - found.y, wanted.y, 1e-6F);
}

/// Those of the mesh, and others by the vertices; what the mesh lacks is left out.
TEST_F(GltfTexture, takes_the_coordinates_that_it_asks_for) {
    png();
    GltfDocument document(gltf(R"("images":[{"uri":"a.png"}],"textures":[{"source":0}],
"holder":{"a":{"index":0,"texCoord":1},"b":{"index":0},"c":{"index":0,"texCoord":2}})"));
    GltfTextures textures(document, warnings_);
    vertices_.own_set = 1;
    vertices_.triangles = std::make_shared<const VertexValues<Vec2>::Triangles>(1);
    vertices_.other_sets[0] = std::make_shared<const std::vector<Vec2>>();
    const auto found = [&](const char* key) {
        return textures.find(document.root().at("holder"), key, TexelUse::colour, vertices_);
    };
    EXPECT_TRUE(std::holds_alternative<UvMapping>(found("a")->image.mapping));
    EXPECT_TRUE(std::holds_alternative<VertexMapping>(found("b")->image.mapping));
    EXPECT_FALSE(found("c"));
    EXPECT_EQ(warnings_.entries().size(), 1U);
    vertices_.has_own_set = false;
    EXPECT_FALSE(found("a"));
}

TEST_F(GltfTexture, times_a_colour_keeps_its_texels) {
    png();
    const auto colour = slot(R"("uri":"a.png")", TexelUse::colour);
    EXPECT_EQ(coloured(colour.image.image, Vec3d(1)), colour.image.image);
    const auto by_half = coloured(colour.image.image, Vec3d(0.5, 1, 1));
    EXPECT_NEAR(by_half->rgb(0, 0).x, 0.5F, 1e-3F);
    EXPECT_NEAR(by_half->rgb(1, 0).y, 0.25F, 5e-3F);
}

TEST_F(GltfTexture, without_an_image_that_can_be_read_is_left_out) {
    GltfDocument document(gltf(R"("textures":[{}],"holder":{"texture":{"index":0}})"));
    GltfTextures textures(document, warnings_);
    EXPECT_FALSE(
        textures.find(document.root().at("holder"), "texture", TexelUse::colour, vertices_));
    ASSERT_EQ(warnings_.entries().size(), 1U);
    EXPECT_NE(fault_of(R"("images":[{"uri":"gone.png"}],"textures":[{"source":0}])"), "");
}

/// One texel of 16 bits: as a colour it is sRGB as that of 8 bits, else as it stands.
TEST_F(GltfTexture, of_16_bits_is_read_as_that_of_8) {
    const std::string image =
        R"("uri":"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABEAIAAADA54+dAAAAD0lEQVR42mNoYHBg+P8fAAcEAr9Z40p+AAAAAElFTkSuQmCC")";
    const Vec3 colour = at(slot(image, TexelUse::colour), {0.5F, 0.5F});
    EXPECT_NEAR(colour.x, 0.2140F, 2e-4F);
    EXPECT_NEAR(colour.y, 0.0509F, 2e-4F);
    EXPECT_EQ(colour.z, 1);
    const Vec3 stored = at(slot(image, TexelUse::linear), {0.5F, 0.5F});
    EXPECT_NEAR(stored.x, 0.5F, 1e-4F);
    EXPECT_NEAR(stored.y, 0.25F, 1e-4F);
}

/// Two texels of grey and alpha, as programs that make files small write them.
TEST_F(GltfTexture, of_grey_with_alpha_keeps_its_alpha) {
    const std::string image =
        R"("uri":"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAQAAABeK7cBAAAADUlEQVR42mPY83+PAwAHqgK4DQ4u/wAAAABJRU5ErkJggg==")";
    EXPECT_EQ(slot(image, TexelUse::colour).image.image->channels(), 4);
    const auto alpha = slot(image, TexelUse::alpha);
    EXPECT_EQ(at(alpha, {0.25F, 0.5F}).x, 1);
    EXPECT_NEAR(at(alpha, {0.75F, 0.5F}).x, 64 / 255.0F, 1e-3F);
    EXPECT_NEAR(at(slot(image, TexelUse::colour), {0.75F, 0.5F}).x, 0.5029F, 1e-3F);
}

/// KTX2 is not read: the picture beside it is, and without one there is no scene.
TEST_F(GltfTexture, of_ktx2_needs_a_picture_beside_it) {
    png();
    const auto members = [](const std::string& source) {
        return R"("extensionsUsed":["KHR_texture_basisu"],"images":[{"uri":"a.ktx2"},{"uri":"a.png"}],
"textures":[{)" +
               source + R"("extensions":{"KHR_texture_basisu":{"source":0}}}],
"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"materials":[{"pbrMetallicRoughness":
{"baseColorTexture":{"index":0}}}],)" +
               testing_support::square_json(R"(,"material":0)");
    };
    const SceneDescription scene = read(members(R"("source":1,)"));
    EXPECT_TRUE(warns(scene,
                      "textures[0]: warning: its image in KTX2 (KHR_texture_basisu) is not "
                      "read: the other is used"));
    EXPECT_FALSE(warns(scene, "extensionsUsed"));
    EXPECT_EQ(fault_of(members("")),
              "scene.gltf: textures[0]: has its image in KTX2 alone (KHR_texture_basisu), which is "
              "not read; export it with PNG or JPEG");
}

/// The name says PNG, the bytes are what they are.
TEST_F(GltfTexture, pictures_are_known_by_their_bytes) {
    const std::string nothing =
        R"("images":[{"mimeType":"image/jpeg","uri":"data:image/jpeg;base64,)"
        R"(iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mP4//8/AAX+Av4zEpUUAAAAAElFTkSuQmCC"}],
"textures":[{"source":0}])";
    EXPECT_EQ(fault_of(nothing), "");
}

}  // namespace
}  // namespace sunfleck::engine
