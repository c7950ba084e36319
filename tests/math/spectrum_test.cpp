// Kinds of spectra, colours there and back, and figures measured with pbrt-v4.
#include "math/spectrum.h"

#include "core/random.h"
#include "math/colour.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

void expect_near(const Vec3& a, const Vec3& b, float tolerance) {
    EXPECT_TRUE(a.equalWithAbsError(b, tolerance)) << a << " is not " << b;
}

/// The colour of light that met a reflectance: integrated at 1 nm.
Vec3 product(const Spectrum& light, const Spectrum& reflectance) {
    Triple sum{};
    for (std::size_t i = 0; i < kVisibleCount; ++i) {
        const float nm = kFirstNm + static_cast<float>(i);
        const double value{light(nm) * reflectance(nm)};
        for (std::size_t k = 0; k < 3; ++k) sum[k] += rgb_response()[i][k] * value;
    }
    return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

TEST(Spectrum, d65_is_white) {
    expect_near(Spectrum::d65().to_rgb(), Vec3(1), 1e-5F);
    EXPECT_NEAR(Spectrum::d65().luminance(), 1, 1e-5);
    EXPECT_NEAR(Spectrum::constant(1).luminance(), 1, 1e-6);
    EXPECT_NEAR(Spectrum::constant(3).scaled(0.5F).luminance(), 1.5, 1e-6);
}

TEST(Spectrum, tables_are_linear_inside_and_zero_outside) {
    const Spectrum curve = Spectrum::table({{400, 1}, {500, 3}, {510, 0.5F}}).scaled(2);
    EXPECT_FLOAT_EQ(curve(400), 2);
    EXPECT_FLOAT_EQ(curve(425), 3);
    EXPECT_FLOAT_EQ(curve(500), 6);
    EXPECT_FLOAT_EQ(curve(505), 3.5F);
    EXPECT_FLOAT_EQ(curve(510), 1);
    EXPECT_EQ(curve(399.9F), 0);
    EXPECT_EQ(curve(510.1F), 0);
    EXPECT_EQ(Spectrum(TabulatedSpectrum{})(500), 0);
    const Spectrum line = Spectrum::table({{500, 7}});
    EXPECT_EQ(line(500), 7);
    EXPECT_EQ(line(501), 0);
}

TEST(Spectrum, tables_out_of_order_are_refused) {
    EXPECT_THROW(Spectrum::table({}), Error);
    EXPECT_THROW(Spectrum::table({{500, 1}, {500, 2}}), Error);
    EXPECT_THROW(Spectrum::table({{500, 1}, {400, 2}}), Error);
}

TEST(Spectrum, greys_are_exact) {
    const Spectrum white = Spectrum::d65();
    for (const float grey : {0.0F, 1e-4F, 0.18F, 0.5F, 0.9F, 1.0F}) {
        const Spectrum albedo = Spectrum::rgb_albedo(Vec3(grey));
        const Spectrum unbounded = Spectrum::rgb_unbounded(Vec3(7 * grey));
        const Spectrum light = Spectrum::rgb_illuminant(Vec3(7 * grey));
        EXPECT_TRUE(albedo.is_constant());
        for (const float nm : {360.0F, 432.1F, 555.0F, 830.0F}) {
            EXPECT_EQ(albedo(nm), grey);
            EXPECT_EQ(unbounded(nm), 7 * grey);
            EXPECT_FLOAT_EQ(light(nm), 7 * grey * white(nm));
        }
    }
}

TEST(Spectrum, albedos_look_like_their_colour) {
    RandomStream stream(11, Purpose::test, 0, 0);
    for (int i = 0; i < 200; ++i) {
        const float r = stream.next_float();
        const float g = stream.next_float();
        const Vec3 rgb(r, g, stream.next_float());
        const Spectrum albedo = Spectrum::rgb_albedo(rgb);
        expect_near(product(Spectrum::d65(), albedo), rgb, 2e-5F);
        for (const float nm : {360.0F, 500.0F, 830.0F}) {
            EXPECT_GE(albedo(nm), 0);
            EXPECT_LE(albedo(nm), 1);
        }
    }
    for (int corner = 1; corner < 7; ++corner) {
        const Vec3 rgb(static_cast<float>(corner & 1), static_cast<float>(corner >> 1 & 1),
                       static_cast<float>(corner >> 2));
        expect_near(product(Spectrum::d65(), Spectrum::rgb_albedo(rgb)), rgb, 2e-5F);
    }
}

TEST(Spectrum, lights_show_their_colour) {
    for (const Vec3& rgb : {Vec3(2, 1, 0.5F), Vec3(0, 0, 30), Vec3(17, 12, 4), Vec3(1e-3F, 0, 0)})
        expect_near(Spectrum::rgb_illuminant(rgb).to_rgb() / rgb.length(), rgb / rgb.length(),
                    2e-5F);
}

TEST(Spectrum, unbounded_is_twice_the_brightest_times_a_reflectance) {
    const Vec3 rgb(3, 0.3F, 1);
    const Spectrum curve = Spectrum::rgb_unbounded(rgb);
    const Spectrum half = Spectrum::rgb_albedo(rgb / 6);
    for (const float nm : {380.0F, 500.0F, 650.0F}) EXPECT_NEAR(curve(nm), 6 * half(nm), 1e-4);
}

TEST(Spectrum, colours_out_of_range_are_brought_in) {
    EXPECT_EQ(Spectrum::rgb_albedo(Vec3(5))(500), 1);
    EXPECT_EQ(Spectrum::rgb_unbounded(Vec3(-1))(500), 0);
    EXPECT_EQ(Spectrum::rgb_illuminant(Vec3(std::nanf("")))(500), 0);
    expect_near(Spectrum::rgb_illuminant(Vec3(1, -2, 0)).to_rgb(), Vec3(1, 0, 0), 2e-5F);
}

// Radiance of a floor of reflectance 0.5 under a distant blackbody of 3000 K, scaled to luminance
// 0.5/pi: measured with pbrt-v4.
TEST(Spectrum, blackbody_has_the_colour_that_pbrt_shows) {
    const Spectrum lamp(BlackbodySpectrum{3000});
    const Vec3 rgb = lamp.to_rgb() * (0.5F / kPi / lamp.luminance());
    EXPECT_NEAR(rgb.x, 0.2818, 0.01 * 0.2818);
    EXPECT_NEAR(rgb.y, 0.1344, 0.01 * 0.1344);
    EXPECT_NEAR(rgb.z, 0.0433, 0.01 * 0.0433);
}

TEST(Spectrum, blackbody_has_maximum_one_at_wiens_wavelength) {
    const Spectrum sun(BlackbodySpectrum{5800});
    EXPECT_NEAR(sun(2.8977721e6F / 5800), 1, 1e-5);
    EXPECT_LT(sun(480), 1);
    EXPECT_LT(sun(520), 1);
    // Planck's law at 5800 K: B(400)/B(700), by hand: (7/4)^5 (exp(3.54379)-1)/(exp(6.20164)-1).
    EXPECT_NEAR(sun(400) / sun(700), 16.4131 * (34.5977 - 1) / (493.56 - 1), 2e-3);
    EXPECT_EQ(Spectrum(BlackbodySpectrum{0})(500), 0);
    EXPECT_EQ(Spectrum(BlackbodySpectrum{1})(500), 0);
    EXPECT_GT(Spectrum(BlackbodySpectrum{1e6F})(500), 0);
}

// Light rgb 2 1 0.5 on reflectance 0.8 0.2 0.05: measured with pbrt-v4, where multiplying the
// numbers would give 0.5093 0.0637 0.0080 (green and blue leak: the bound on blue is absolute).
TEST(Spectrum, products_of_colours_are_those_of_pbrt) {
    const Vec3 rgb = product(Spectrum::rgb_illuminant(Vec3(2, 1, 0.5F)),
                             Spectrum::rgb_albedo(Vec3(0.8F, 0.2F, 0.05F))) /
                     kPi;
    EXPECT_NEAR(rgb.x, 0.4660, 0.003 * 0.4660);
    EXPECT_NEAR(rgb.y, 0.0601, 0.01 * 0.0601);
    EXPECT_NEAR(rgb.z, 0.0003, 0.0003);
}

// Distant "spectrum" 300:1 900:1, scaled to luminance 0.5/pi: measured with pbrt-v4.
TEST(Spectrum, flat_light_has_the_colour_that_pbrt_shows) {
    const Vec3 rgb = Spectrum::table({{300, 1}, {900, 1}}).to_rgb() * (0.5F / kPi);
    expect_near(rgb, Vec3(0.1918F, 0.1509F, 0.1447F), 3e-4F);
}

}  // namespace
}  // namespace sunfleck::engine
