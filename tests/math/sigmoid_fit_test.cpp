// Fitted reflectances must look like the colours that were asked for.
#include "math/sigmoid_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunfleck::engine {
namespace {

double error_of_fit(const Triple& rgb) {
    const Triple c = fit_sigmoid(rgb);
    Triple seen{};
    for (std::size_t i = 0; i < kVisibleCount; ++i) {
        const double nm = kFirstNm + static_cast<double>(i);
        const double value = sigmoid((c[0] * nm + c[1]) * nm + c[2]) * white()[i];
        for (std::size_t k = 0; k < 3; ++k) seen[k] += value * rgb_response()[i][k];
    }
    double error = 0;
    for (std::size_t k = 0; k < 3; ++k) error = std::max(error, std::abs(seen[k] - rgb[k]));
    return error;
}

TEST(Sigmoid, is_accurate_and_reaches_its_ends) {
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(sigmoid(0.0F), 0.5F);
    EXPECT_EQ(sigmoid(infinity), 1.0F);
    EXPECT_EQ(sigmoid(-infinity), 0.0F);
    EXPECT_EQ(sigmoid(-1e30F), 0.0F);
    EXPECT_FLOAT_EQ(sigmoid(-1000.0F), 2.4999981e-7F);  // 1/(4 x^2) - 3/(16 x^4)
    for (const double x : {-30.0, -1.0, 0.3, 8.0})
        EXPECT_NEAR(sigmoid(x), 0.5 + 0.5 * x / std::sqrt(1 + x * x), 1e-15);
}

// The whole cube, its faces, edges and corners included.
TEST(FitSigmoid, reaches_every_colour_of_srgb) {
    constexpr std::size_t kSteps = 9;
    for (std::size_t i = 0; i < kSteps * kSteps * kSteps; ++i) {
        Triple rgb{};
        std::size_t digits = i;
        for (double& value : rgb) {
            value = static_cast<double>(digits % kSteps) / (kSteps - 1);
            digits /= kSteps;
        }
        if (rgb[0] == rgb[1] && rgb[1] == rgb[2]) continue;
        EXPECT_LT(error_of_fit(rgb), 1e-6) << rgb[0] << ' ' << rgb[1] << ' ' << rgb[2];
    }
}

TEST(FitSigmoid, reaches_dark_bright_and_nearly_grey_colours) {
    for (const Triple& rgb : {Triple{1e-3, 0, 0}, Triple{1e-6, 0, 2e-6}, Triple{1, 1, 0.999},
                              Triple{0.5, 0.5, 0.50001}, Triple{0, 1e-4, 1e-4}})
        EXPECT_LT(error_of_fit(rgb), 1e-6) << rgb[0] << ' ' << rgb[1] << ' ' << rgb[2];
    EXPECT_TRUE(std::isfinite(error_of_fit({1e-38, 0, 1e-37})));
}

TEST(FitSigmoid, nearly_grey_is_nearly_flat) {
    const Triple c = fit_sigmoid({0.5, 0.5, 0.50001});
    for (const double nm : {360.0, 500.0, 830.0})
        EXPECT_NEAR(sigmoid((c[0] * nm + c[1]) * nm + c[2]), 0.5, 5e-4);
}

}  // namespace
}  // namespace sunfleck::engine
