// The table of reflectances: how far colours are from what was asked for, greys, other scales.
#include "math/sigmoid_table.h"

#include "core/random.h"
#include "math/colour.h"
#include "math/sigmoid_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// How the colour's reflectance looks under D65, by the observer at 1 nm.
Vec3 seen(const SigmoidTable& table, const Vec3& rgb) {
    const auto c = table.coefficients(rgb);
    Triple sum{};
    for (std::size_t i = 0; i < kVisibleCount; ++i) {
        const double t = (static_cast<double>(i) + kFirstNm - kMiddleNm) / kHalfRangeNm;
        const double x = c[0] + t * (c[1] + t * c[2]);
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += rgb_response()[i][k] * white()[i] * sigmoid(x);
    }
    return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

float largest_difference(const Vec3& a, const Vec3& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

TEST(SigmoidTable, looks_as_asked_to_a_thousandth) {
    const SigmoidTable& table = SigmoidTable::srgb();
    RandomStream random(1, Purpose::test, 0, 0);
    double sum = 0;
    float most = 0;
    constexpr int kColours = 2000;
    for (int i = 0; i < kColours; ++i) {
        const Vec3 rgb(random.next_float(), random.next_float(), random.next_float());
        const float error = largest_difference(seen(table, rgb), rgb);
        sum += double{error};
        most = std::max(most, error);
    }
    EXPECT_LT(sum / kColours, 1.2e-3);
    EXPECT_LT(most, 4e-3F);
}

TEST(SigmoidTable, holds_the_corners_and_the_dark) {
    const SigmoidTable& table = SigmoidTable::srgb();
    for (const Vec3& rgb :
         {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 1, 0), Vec3(0, 1, 1), Vec3(1, 0, 1),
          Vec3(1e-3F, 0, 0), Vec3(1e-8F, 2e-8F, 0), Vec3(1, 1, 0.999F), Vec3(0.3F, 0.3F, 0.31F)})
        EXPECT_LT(largest_difference(seen(table, rgb), rgb), 4e-3F) << rgb;
}

TEST(SigmoidTable, evaluates_at_the_wavelengths) {
    const SigmoidTable& table = SigmoidTable::srgb();
    const Wavelengths wavelengths = Wavelengths::of_pass({5, 2});
    const Vec3 rgb(0.7F, 0.2F, 0.4F);
    const auto c = table.coefficients(rgb);
    const SampledSpectrum albedo = table.albedo(rgb, wavelengths);
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        const double t = (double{wavelengths.nm[i]} - 595) / 235;
        EXPECT_NEAR(albedo[i], sigmoid(c[0] + t * (c[1] + t * c[2])), 1e-6);
    }
    const SampledSpectrum half = table.albedo(Vec3(0.5F), wavelengths);
    EXPECT_EQ(half, SampledSpectrum(0.5F));
    EXPECT_EQ(table.albedo({-1, 2, 2}, wavelengths), table.albedo({0, 1, 1}, wavelengths));
    EXPECT_EQ(table.albedo(Vec3(0), wavelengths), SampledSpectrum(0));
}

TEST(SigmoidTable, bright_colours_are_scaled) {
    const SigmoidTable& table = SigmoidTable::srgb();
    const Wavelengths wavelengths = Wavelengths::of_pass({5, 2});
    const SampledSpectrum bright = table.unbounded({40, 10, 20}, wavelengths);
    const SampledSpectrum half = table.albedo({0.5F, 0.125F, 0.25F}, wavelengths);
    for (std::size_t i = 0; i < kWavelengths; ++i) EXPECT_FLOAT_EQ(bright[i], 80 * half[i]);
    EXPECT_EQ(table.unbounded(Vec3(0), wavelengths), SampledSpectrum(0));
    EXPECT_EQ(table.unbounded(Vec3(3), wavelengths), SampledSpectrum(3));
}

}  // namespace
}  // namespace sunfleck::engine
