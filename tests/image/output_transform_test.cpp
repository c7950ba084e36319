// The output transform: each step by itself, and their order.
#include "image/output_transform.h"

#include "image/srgb.h"
#include "math/spectrum.h"
#include "math/white_balance.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>

#include <limits>

namespace sunfleck::engine {
namespace {

Picture even_picture(int width, int height, const Vec3& light) {
    Picture picture{width, height, {}, {}};
    for (int c = 0; c < 3; ++c)
        std::ranges::fill(picture.add(std::string(1, "RGB"[c])).values, light[c]);
    return picture;
}

/// Returns the values of a single pixel.
Vec3 shown(const Vec3& light, const OutputTransform& transform) {
    const std::vector<float> v = screen_values(even_picture(1, 1, light), transform, "a.png");
    return {v[0], v[1], v[2]};
}

TEST(OutputTransform, is_the_encoding_alone_by_default) {
    for (const float light : {-1.0F, 0.0F, 1e-4F, 0.18F, 0.7F, 1.0F, 5.0F})
        EXPECT_EQ(shown(Vec3(light), {}).y, srgb_encode(light));
    EXPECT_EQ(shown(Vec3(0.1F), {.exposure = 2}).x, srgb_encode(0.4F));
}

/// The light of a lamp of that temperature, as the renderer itself has it.
TEST(OutputTransform, makes_a_lamp_of_the_temperature_white) {
    for (const double kelvin : {2000.0, 2856.0, 3200.0}) {
        const Vec3 lamp = Spectrum(BlackbodySpectrum{static_cast<float>(kelvin)}).to_rgb();
        const Vec3 light = lamp * (0.4F / lamp.y);
        EXPECT_GT(light.x, 1.5F * light.z) << "it is reddish as it is";
        const Vec3 values = shown(light, {.white_balance = kelvin});
        EXPECT_NEAR(values.x, values.y, 0.006) << kelvin;
        EXPECT_NEAR(values.z, values.y, 0.006) << kelvin;
    }
}

TEST(OutputTransform, leaves_white_at_the_temperature_of_daylight) {
    for (const Vec3& light : {Vec3(0.5F), Vec3(0.8F, 0.1F, 0.2F)}) {
        const Vec3 values = shown(light, {.white_balance = 6504});
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(values[c], srgb_encode(light[c]), 0.003);
    }
    EXPECT_GT(shown(Vec3(0.5F), {.white_balance = 3200}).z, 0.8F) << "daylight is blue there";
}

TEST(OutputTransform, darkens_corners_by_the_stops_and_the_middle_by_none) {
    const Picture picture = even_picture(400, 300, Vec3(0.5F));
    const std::vector<float> values = screen_values(picture, {.vignette = 2}, "a.png");
    const auto light_at = [&](std::size_t x, std::size_t y) {
        return srgb_decode(values[3 * (y * 400 + x)]);
    };
    EXPECT_NEAR(light_at(0, 0), 0.125F, 0.002F);
    EXPECT_NEAR(light_at(399, 299), 0.125F, 0.002F);
    EXPECT_NEAR(light_at(200, 150), 0.5F, 0.001F);
    // cos^4 of the angle whose tangent is .8 of the corner's: 2 stops there are tan^2 = 1.
    EXPECT_NEAR(light_at(0, 150), 0.5F / (1.64F * 1.64F), 0.002F);
}

TEST(OutputTransform, applies_tones_after_white_balance_and_exposure) {
    const Vec3 light(0.3F, 0.2F, 0.1F);
    const Rows balance = white_balance(3000);
    const Triple rgb = balance * Triple{0.6, 0.4, 0.2};
    const Vec3 expected = toned(
        Tone::agx,
        Vec3(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])));
    const Vec3 values = shown(light, {.exposure = 1, .white_balance = 3000, .tone = Tone::agx});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(values[c], srgb_encode(expected[c]), 1e-5);
}

TEST(OutputTransform, refuses_glare_of_light_without_end) {
    const Picture picture = even_picture(2, 2, Vec3(std::numeric_limits<float>::infinity()));
    EXPECT_EQ(screen_values(picture, {}, "a.png")[0], 1);
    try {
        screen_values(picture, {.glare = 0.1}, "a.png");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "a.png: glare cannot spread light that is not finite; leave --glare out, or "
                     "lower --exposure");
    }
}

}  // namespace
}  // namespace sunfleck::engine
