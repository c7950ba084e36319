// Tone curves: laws that hold for each of them, and points of the published curves.
#include "image/tone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sunfleck::engine {
namespace {

Vec3 grey_light(double light) {
    return Vec3(static_cast<float>(light));
}

class ToneLaws : public testing::TestWithParam<ChoiceRow<Tone>> {};

TEST_P(ToneLaws, black_is_black_and_white_is_white) {
    const Tone tone = GetParam().value;
    EXPECT_EQ(toned(tone, Vec3(0)), Vec3(0));
    EXPECT_EQ(toned(tone, Vec3(-1)), Vec3(0));
    EXPECT_EQ(toned(tone, Vec3(std::numeric_limits<float>::quiet_NaN())), Vec3(0));
    const ToneCurve& curve = tone_curve(tone);
    for (const double light : {curve.white, 2 * curve.white, 1e9})
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(toned(tone, grey_light(light))[c], 1, 1e-6);
    EXPECT_NEAR(curve.value(curve.white * (1 - 1e-12)), 1, 1e-6) << "it does not leap at white";
}

TEST_P(ToneLaws, more_light_is_never_darker) {
    float before = 0;
    for (double stops = -20; stops <= 12; stops += 0.01) {
        const float now = toned(GetParam().value, grey_light(std::exp2(stops))).y;
        EXPECT_GE(now, before) << stops;
        before = now;
    }
    EXPECT_NEAR(before, 1, 1e-6);
}

TEST_P(ToneLaws, grey_stays_grey) {
    for (double stops = -12; stops <= 6; stops += 0.25) {
        const Vec3 shown = toned(GetParam().value, grey_light(std::exp2(stops)));
        EXPECT_NEAR(shown.x, shown.y, 2e-7 + 2e-6 * shown.y) << stops;
        EXPECT_NEAR(shown.z, shown.y, 2e-7 + 2e-6 * shown.y) << stops;
    }
}

TEST_P(ToneLaws, all_light_is_shown_within_black_and_white) {
    for (const float red : {0.0F, 1e-3F, 0.2F, 1.0F, 30.0F, 1e6F})
        for (const float green : {-0.1F, 0.0F, 0.5F, 3.0F})
            for (const float blue : {0.0F, 0.1F, 200.0F}) {
                const Vec3 shown = toned(GetParam().value, Vec3(red, green, blue));
                for (int c = 0; c < 3; ++c) {
                    EXPECT_GE(shown[c], 0);
                    EXPECT_LE(shown[c], 1);
                }
            }
}

TEST_P(ToneLaws, infinite_light_is_white) {
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_NEAR(toned(GetParam().value, Vec3(infinity)).y, 1, 1e-6);
    EXPECT_NEAR(toned(GetParam().value, Vec3(infinity, 0, 0)).x, 1, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Of, ToneLaws, testing::ValuesIn(kTones),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Tone, none_is_the_light_itself) {
    EXPECT_EQ(toned(Tone::none, Vec3(0.1F, 0.5F, 0.9F)), Vec3(0.1F, 0.5F, 0.9F));
}

/// Hable's own form, with his six numbers, an exposure of 2 and a white of 11.2.
TEST(Tone, filmic_is_hables_formula) {
    const auto published = [](double x) {
        return (x * (0.15 * x + 0.10 * 0.50) + 0.20 * 0.02) /
                   (x * (0.15 * x + 0.50) + 0.20 * 0.30) -
               0.02 / 0.30;
    };
    for (const double light : {0.001, 0.18, 0.5, 1.0, 4.0})
        EXPECT_NEAR(toned(Tone::filmic, grey_light(light)).y,
                    published(2 * light) / published(11.2), 1e-6);
}

/// The ACES reference brings a grey of .18 to about a tenth of white (4.8 of 48 cd/m^2).
TEST(Tone, aces_has_the_grey_of_the_reference) {
    EXPECT_NEAR(toned(Tone::aces, grey_light(0.18)).y, 0.1, 0.006);
}

/// The polynomial of the sixth degree by which AgX is usually approximated (B. Wrensch, 2023),
/// which is up to .006 beside the curve.
TEST(Tone, agx_is_near_its_usual_approximation) {
    for (double x = 0.05; x < 1; x += 0.05) {
        const double light = 0.18 * std::exp2(16.5 * x - 10);
        const double approximated =
            ((((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x) -
            0.00232;
        const double encoded = std::pow(toned(Tone::agx, grey_light(light)).y, 1 / 2.2);
        EXPECT_NEAR(encoded, approximated, 0.006) << x;
    }
    EXPECT_NEAR(toned(Tone::agx, grey_light(0.18)).y, std::pow(0.5, 2.2), 1e-6);
}

/// A light that has one channel alone does not stay so when it is brighter than a screen.
TEST(Tone, agx_and_aces_bring_bright_colours_to_white) {
    for (const Tone tone : {Tone::aces, Tone::agx}) {
        const Vec3 dim = toned(tone, Vec3(0.02F, 0, 0.1F));
        const Vec3 bright = toned(tone, Vec3(20, 0, 100));
        EXPECT_LT(dim.x, 0.5F * dim.z);
        EXPECT_GT(bright.x, 0.9F * bright.z);
    }
}

}  // namespace
}  // namespace sunfleck::engine
