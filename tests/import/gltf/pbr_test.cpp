// Roughness and its anisotropy.
#include "import/gltf/pbr.h"

#include "gltf_files.h"

namespace sunfleck::engine {
namespace {

/// Along the tangent alpha goes to 1 with the square of the strength (KHR_materials_anisotropy).
TEST(GltfPbrTest, anisotropy_widens_along_the_tangent) {
    GltfPbr pbr;
    pbr.roughness = 0.5;
    pbr.anisotropy = 0.6;
    const Roughness roughness = roughness_of(pbr);
    EXPECT_FLOAT_EQ(roughness.u.constant(), 0.25F + 0.75F * 0.36F);
    EXPECT_FLOAT_EQ(roughness.v.constant(), 0.25F);
    EXPECT_FLOAT_EQ(facets_of(0.5, 0.6)->alpha_x, roughness.u.constant());
    pbr.anisotropy = 0;
    EXPECT_EQ(roughness_of(pbr).u.constant(), roughness_of(pbr).v.constant());
    pbr.roughness = 0;
    EXPECT_FALSE(facets_of(0)) << "smooth";
}

/// Of one channel, texel by texel.
GltfTextures::Slot slot_of(const std::vector<std::uint8_t>& texels) {
    static const nlohmann::json kNothing = nlohmann::json::object();
    ImageKind image;
    image.image = std::make_shared<const Image>(Vec2i(static_cast<int>(texels.size()), 1), 1,
                                                texels, Encoding{Encoding::Kind::linear});
    image.nearest = true;
    return {image, JsonPlace(kNothing, "a.gltf", "")};
}

/// alpha + (1 - alpha) strength^2, with both from textures.
TEST(GltfPbrTest, anisotropy_of_metal_follows_its_texture) {
    GltfPbr pbr;
    pbr.roughness = 0.5;
    pbr.anisotropy = 0.5;
    pbr.direction = slot_of({0, 255});
    pbr.green = slot_of({255, 0, 255, 0});
    const Roughness roughness = roughness_of(pbr);
    const auto along = [&](float u) {
        return roughness.u.at(TexturePoint(Vec3(0), Vec3(0, 0, 1), {u, 0.5F}));
    };
    EXPECT_NEAR(along(0.125F), 0.25F, 1e-3F) << "no strength";
    EXPECT_NEAR(along(0.375F), 0, 1e-3F);
    EXPECT_NEAR(along(0.625F), 0.25F + 0.75F * 0.25F, 1e-3F);
    EXPECT_NEAR(along(0.875F), 0.25F, 1e-3F) << "smooth across";
}

TEST(GltfPbrTest, a_roughness_that_hardly_varies_is_its_mean) {
    const RoughnessSteps even = steps_of(slot_of({127, 128}), 1);
    EXPECT_TRUE(even.amounts.empty());
    EXPECT_NEAR(even.roughness.at(0), 0.5, 1e-6);
    const RoughnessSteps wide = steps_of(slot_of({64, 128}), 1);
    EXPECT_EQ(wide.roughness, (std::vector<double>{0.25, 0.375, 0.5, 0.625}));
    EXPECT_EQ(wide.amounts.size(), 3U);
    EXPECT_EQ(steps_of({}, 0.3).roughness, std::vector<double>{0.3});
}

}  // namespace
}  // namespace sunfleck::engine
