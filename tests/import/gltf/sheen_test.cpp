// Sheen as a matt layer: its share of the surface is the albedo of the lobe that it stands for.
#include "import/gltf/sheen.h"

#include "core/random.h"
#include "gltf_files.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

using testing_support::expect_same;
using testing_support::square_json;
using testing_support::warns;

/// The lobe of KHR_materials_sheen for white, times the incoming cosine.
double sheen(const Vec3d& to, const Vec3d& from, double roughness) {
    const double alpha = roughness * roughness;
    const auto l = [&](double x) {
        const double w = (1 - alpha) * (1 - alpha);
        const auto lerp = [&](double a, double b) { return (1 - w) * a + w * b; };
        return lerp(21.5473, 25.3245) /
                   (1 + lerp(3.82987, 3.32435) * std::pow(x, lerp(0.19823, 0.16801))) +
               lerp(-1.97760, -1.27393) * x + lerp(-4.32054, -4.85967);
    };
    const auto lambda = [&](double cosine) {
        return cosine < 0.5 ? std::exp(l(cosine)) : std::exp(2 * l(0.5) - l(1 - cosine));
    };
    const double half = (to + from).normalized().z;
    const double d = (2 + 1 / alpha) * std::pow(1 - half * half, 0.5 / alpha) / (2 * kPiDouble);
    return d / (1 + lambda(to.z) + lambda(from.z)) / (4 * to.z * from.z) * from.z;
}

Vec3d uniform_up(RandomStream& random) {
    const double z = random.next();
    const double angle = 2 * kPiDouble * random.next();
    const double flat = std::sqrt(1 - z * z);
    return {flat * std::cos(angle), flat * std::sin(angle), z};
}

/// By 400,000 pairs of directions: to 1% at 4 sigma.
TEST(GltfSheen, mean_albedo_is_the_integral_of_its_lobe) {
    RandomStream random(5, Purpose::test, 0, 0);
    for (const double roughness : {0.3, 0.6, 1.0}) {
        double sum = 0;
        constexpr int kPairs = 400'000;
        for (int i = 0; i < kPairs; ++i) {
            const Vec3d to = uniform_up(random);
            sum += 2 * to.z * 2 * kPiDouble * sheen(to, uniform_up(random), roughness);
        }
        EXPECT_NEAR(mean_sheen_albedo(roughness) / (sum / kPairs), 1, 0.015) << roughness;
    }
    for (double roughness = 0; roughness <= 1; roughness += 0.05) {
        EXPECT_GE(mean_sheen_albedo(roughness), 0) << roughness;
        EXPECT_LT(mean_sheen_albedo(roughness), 0.5) << roughness;
    }
}

class GltfSheenFiles : public testing_support::GltfFiles {
protected:
    SceneDescription with(const std::string& extensions) const {
        return read(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"materials":[{
"pbrMetallicRoughness":{"metallicFactor":0},"extensions":{)" +
                    extensions + "}}]," + square_json(R"(,"material":0)"));
    }
    static const Material& material_of(const SceneDescription& scene) {
        return scene.materials.at(scene.shapes.at(0).material);
    }
};

TEST_F(GltfSheenFiles, takes_the_share_of_its_brightest_channel) {
    const SceneDescription scene = with(
        R"("KHR_materials_sheen":{"sheenColorFactor":[0.2,0.4,0.8],"sheenRoughnessFactor":0.5})");
    const auto& mix = std::get<MixMaterial>(material_of(scene));
    EXPECT_NEAR(mix.amount.constant(), 0.8 * mean_sheen_albedo(0.5), 1e-6);
    const auto& layer = std::get<DiffuseMaterial>(scene.materials.at(mix.components[1]));
    expect_same(layer.reflectance.curve(), Spectrum::rgb_albedo({0.25F, 0.5F, 1}));
    EXPECT_TRUE(std::holds_alternative<CoatedDiffuseMaterial>(scene.materials[mix.components[0]]));
    EXPECT_TRUE(warns(scene, "KHR_materials_sheen: warning: sheen is a matt layer of its colour"));
}

TEST_F(GltfSheenFiles, that_is_black_or_under_a_coat_is_none) {
    EXPECT_TRUE(std::holds_alternative<CoatedDiffuseMaterial>(
        material_of(with(R"("KHR_materials_sheen":{"sheenRoughnessFactor":0.5})"))));
    const SceneDescription coated = with(R"("KHR_materials_sheen":{"sheenColorFactor":[1,1,1]},
"KHR_materials_clearcoat":{"clearcoatFactor":1})");
    EXPECT_TRUE(warns(coated, "sheen is left out under a coat"));
}

/// Two texels, linear 1 and 0.5 in all channels, times a colour.
TEST_F(GltfSheenFiles, follows_its_texture) {
    GltfDocument document(
        gltf(R"("images":[{"uri":"data:image/png;base64,)"
             "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAEUlEQVR42mP4z8Dwn6GBoQEA"
             R"(DvwC/0yqyAQAAAAASUVORK5CYII="}],"textures":[{"source":0}],
"extension":{"sheenColorFactor":[0.5,0.25,0],"sheenRoughnessFactor":1,"sheenColorTexture":{"index":0}})"));
    Warnings warnings;
    GltfTextures textures(document, warnings);
    const auto layer = *sheen_of(document.root().at("extension"), textures, GltfVertices());
    const TexturePoint first(Vec3(0), Vec3(0, 0, 1), {0.25F, 0.5F});
    const auto slot = textures.find(document.root().at("extension"), "sheenColorTexture",
                                    TexelUse::colour, GltfVertices());
    const Vec3 texel = image_rgb(slot->image, first);
    const double most = std::max(0.5F * texel.x, 0.25F * texel.y);
    EXPECT_NEAR(layer.amount.at(first), most * mean_sheen_albedo(1), 1e-3);
}

}  // namespace
}  // namespace sunfleck::engine
