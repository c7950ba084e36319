// What media emit, as scene files tell it, and media of a colour per voxel.
#include "import/pbrt/medium_glow.h"

#include "import/pbrt/scene_text.h"
#include "medium/medium.h"
#include "scene/media.h"

namespace sunfleck::engine {
namespace {

const std::string kEvenFire = "MakeNamedMedium \"fire\" \"string type\" \"homogeneous\" ";
const std::string kFireGrid =
    "MakeNamedMedium \"fire\" \"string type\" \"uniformgrid\" \"integer nx\" 2 "
    "\"float density\" [1 3] ";
const std::string kColours =
    "MakeNamedMedium \"fire\" \"string type\" \"rgbgrid\" \"integer nx\" 2 ";
const std::string kBall = "MediumInterface \"fire\" \"\" Shape \"sphere\" ";

std::shared_ptr<const Glow> glow_in(const std::string& text) {
    return read_world(text + kBall).media.all.at(1).glow;
}

TEST(ReadGlow, of_an_even_medium_is_a_spectrum_times_a_number) {
    EXPECT_EQ(glow_in(kEvenFire), nullptr);
    EXPECT_EQ(glow_in(kEvenFire + "\"rgb Le\" [0 0 0] "), nullptr);
    EXPECT_EQ(glow_in(kEvenFire + "\"rgb Le\" [1 1 1] \"float Lescale\" 0 "), nullptr);
    const auto glow = glow_in(kEvenFire + "\"blackbody Le\" 3000 \"float Lescale\" 4 ");
    ASSERT_NE(glow, nullptr);
    EXPECT_NEAR(glow->radiance.luminance(), 4, 1e-4F);  // pbrt-v4 divides by the luminance
    EXPECT_FALSE(glow->varies());
}

TEST(ReadGlow, of_a_grid_varies_by_a_factor_and_a_temperature) {
    const auto even = glow_in(kFireGrid + "\"rgb Le\" [2 2 2] \"float Lescale\" 3 ");
    ASSERT_NE(even, nullptr);
    EXPECT_FALSE(even->varies());
    EXPECT_NEAR(even->radiance.luminance(), 6, 1e-4F);
    const auto factor = glow_in(kFireGrid + "\"rgb Le\" [2 2 2] \"float Lescale\" [0 5] ");
    ASSERT_NE(factor, nullptr);
    EXPECT_FLOAT_EQ(factor->factor_at({0.75F, 0.5F, 0.5F}), 5);
    EXPECT_FLOAT_EQ(factor->factor_at({0.25F, 0.5F, 0.5F}), 0);
    const auto heat = glow_in(kFireGrid +
                              "\"float temperature\" [-3 8] \"float temperaturecutoff\" 2 "
                              "\"float temperaturescale\" 300 \"float Lescale\" [1 2] ");
    ASSERT_NE(heat, nullptr);
    EXPECT_FLOAT_EQ(heat->black_body_at({0.75F, 0.5F, 0.5F}).kelvin, 1800);
    EXPECT_FLOAT_EQ(heat->black_body_at({0.25F, 0.5F, 0.5F}).kelvin, 0);
    EXPECT_FLOAT_EQ(heat->factor_at({0.75F, 0.5F, 0.5F}), 2);
    EXPECT_GT(heat->power->at({0.75F, 0.5F, 0.5F}), 10 * heat->power->at({0.25F, 0.5F, 0.5F}));
    EXPECT_EQ(glow_in(kFireGrid + "\"float temperature\" [50 90] "), nullptr);  // nothing glows
}

TEST(ReadGlow, that_cannot_be_is_told) {
    const auto says = [](const std::string& text, const std::string& part) {
        EXPECT_TRUE(contains(world_error(text + kBall), part)) << world_error(text + kBall);
    };
    says(kEvenFire + "\"rgb Le\" [1 1 1] \"float Lescale\" -1 ", "\"Lescale\" is negative");
    says(kEvenFire + "\"rgb Le\" [1e20 1e20 1e20] \"float Lescale\" 1e30 ", "too bright");
    says(kFireGrid + "\"rgb Le\" [1 1 1] \"float temperature\" [1 2] ", "both \"Le\" and");
    says(kFireGrid + "\"rgb Le\" [1 1 1] \"float Lescale\" [1 2 3] ", "\"Lescale\" has 3 values");
    says(kFireGrid + "\"rgb Le\" [1 1 1] \"float Lescale\" [1 -2] ", "number 2 of 2");
    says(kFireGrid + "\"float temperature\" [1e30 2] ", "\"temperature\" has a value");
    says(kColours, "no \"sigma_a\"");
    says(kColours + "\"rgb sigma_a\" [1 1 1] ", "\"sigma_a\" has 1 values");
    says(kColours + "\"rgb sigma_s\" [1 1 1 1 1 1] \"rgb Le\" [1 1 1 1 1 1] ", "no \"sigma_a\"");
}

/// Absorption and scattering times density are right in sum over all voxels, and light as well.
TEST(ReadColourGrids, keep_the_sums_of_their_voxels) {
    const SceneDescription scene = read_world(kColours +
                                              "\"rgb sigma_a\" [1 1 1 5 5 5] \"float scale\" 2 "
                                              "\"rgb sigma_s\" [3 3 3 1 1 1] "
                                              "\"rgb Le\" [0 0 0 4 4 4] \"float Lescale\" 10 " +
                                              kBall);
    const Medium& medium = scene.media.all.at(1);
    const Vec3 first(0.25F, 0.5F, 0.5F);
    const Vec3 second(0.75F, 0.5F, 0.5F);
    const float both = density_at(*medium.density, first) + density_at(*medium.density, second);
    EXPECT_NEAR(medium.absorption(550) * both, 12, 1e-3F);
    EXPECT_NEAR(medium.scattering(550) * both, 8, 1e-3F);
    EXPECT_NEAR(medium.glow->factor_at(second) * medium.glow->radiance.luminance(), 40, 1e-2F);
    EXPECT_NEAR(medium.glow->factor_at(first), 0, 1e-6F);
}

}  // namespace
}  // namespace sunfleck::engine
