// Fresnel reflectances against the complex equations, and against numbers known by heart.
#include "bsdf/fresnel.h"

#include "laws/bsdf_fresnel.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

constexpr std::array kCosines{1.0F, 0.97F, 0.8F, 0.5F, 0.2F, 0.03F, 1e-3F};

TEST(Fresnel, dielectric_is_the_textbook) {
    for (const float eta : {1.33F, 1.5F, 2.4F, 1 / 1.5F, 1 / 2.4F, 1.001F})
        for (const float c : kCosines)
            EXPECT_NEAR(dielectric_reflectance(c, eta), laws::fresnel(c, eta), 5e-6) << c << eta;
}

TEST(Fresnel, dielectric_by_heart) {
    EXPECT_NEAR(dielectric_reflectance(1, 1.5F), 0.04F, 1e-7F);  // ((n - 1) / (n + 1))^2
    EXPECT_EQ(dielectric_reflectance(0.7F, 1 / 1.5F), 1);        // beyond 41.8 degrees inside
    EXPECT_NEAR(dielectric_reflectance(0.3F, 1), 0, 1e-7F);
    // Brewster's angle: only the polarisation across is reflected.
    const float brewster = 1 / std::sqrt(1 + 1.5F * 1.5F);
    const float across = (1 - 2.25F) / (1 + 2.25F);
    EXPECT_NEAR(dielectric_reflectance(brewster, 1.5F), across * across / 2, 1e-6F);
}

/// Seen from the other side, along the same ray, a boundary reflects the same share.
TEST(Fresnel, dielectric_is_the_same_from_both_sides) {
    for (const float c : kCosines) {
        const float inside = refracted_cosine(1 - c * c, 1.5F);
        EXPECT_NEAR(dielectric_reflectance(c, 1.5F), dielectric_reflectance(inside, 1 / 1.5F),
                    2e-4F);
        EXPECT_NEAR(dielectric_reflectance(c, inside, 1.5F),
                    dielectric_reflectance(inside, c, 1 / 1.5F), 1e-6F);
    }
}

TEST(Fresnel, conductor_is_the_textbook) {
    SampledSpectrum eta;
    SampledSpectrum k;
    eta.values = {0.13F, 0.2F, 1.0F, 1.5F, 2.8F, 1.0F, 0.05F, 1.6F};
    k.values = {4.0F, 2.5F, 7.0F, 0.0F, 3.2F, 200.0F, 1.0F, 1.9F};
    for (const float c : kCosines) {
        const SampledSpectrum r = conductor_reflectance(c, eta, k);
        for (std::size_t i = 0; i < kWavelengths; ++i)
            EXPECT_NEAR(r[i], laws::fresnel(c, {eta[i], k[i]}), 3e-5) << c << " wavelength " << i;
    }
}

/// At normal incidence a metal of eta 1 and k = 2 sqrt(r) / sqrt(1 - r) reflects r.
TEST(Fresnel, conductor_of_given_reflectance) {
    for (const float r : {0.0F, 0.1F, 0.5F, 0.9F, 0.9999F}) {
        const float k = 2 * std::sqrt(r) / std::sqrt(1 - r);
        EXPECT_NEAR(conductor_reflectance(1, SampledSpectrum(1), SampledSpectrum(k))[5], r, 1e-5F);
    }
}

/// Exactly: a share of -1e-9 would make a negative weight.
TEST(Fresnel, stays_within_zero_and_one) {
    SampledSpectrum k;
    k.values = {0, 1e-4F, 0.01F, 0.3F, 1, 3, 30, 1000};
    for (const float index : {0.02F, 0.5F, 1.0F, 1.001F, 1.5F, 40.0F})
        for (int i = 1; i <= 1000; ++i) {
            const float c = static_cast<float>(i) / 1000;
            const float glass = dielectric_reflectance(c, index);
            EXPECT_TRUE(glass >= 0 && glass <= 1) << c << " " << index;
            const SampledSpectrum r = conductor_reflectance(c, SampledSpectrum(index), k);
            EXPECT_TRUE(r.min() >= 0 && r.max() <= 1) << c << " " << index;
        }
}

}  // namespace
}  // namespace sunfleck::engine
