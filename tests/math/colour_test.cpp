// The observer's integrals, the white of sRGB, and its matrices, against printed values.
#include "math/colour.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

Triple sum_of_responses(const std::array<double, kVisibleCount>& radiance) {
    Triple rgb{};
    for (std::size_t i = 0; i < kVisibleCount; ++i)
        for (std::size_t k = 0; k < 3; ++k) rgb[k] += rgb_response()[i][k] * radiance[i];
    return rgb;
}

TEST(Colour, observer_integrates_to_one) {
    double sum = 0;
    for (const double value : luminance_response()) sum += value;
    EXPECT_NEAR(sum, 1, 1e-6);
}

TEST(Colour, white_is_one_one_one) {
    const Triple rgb = sum_of_responses(white());
    for (const double value : rgb) EXPECT_NEAR(value, 1, 1e-12);
}

// IEC 61966-2-1 prints the matrix to four digits, for a white rounded to x, y = 0.3127, 0.3290.
TEST(Colour, matrix_is_that_of_srgb) {
    const Triple red = xyz_of_rgb({1, 0, 0});
    const Triple green = xyz_of_rgb({0, 1, 0});
    const Triple blue = xyz_of_rgb({0, 0, 1});
    const std::array<Triple, 3> printed{Triple{0.4124, 0.2126, 0.0193},
                                        Triple{0.3576, 0.7152, 0.1192},
                                        Triple{0.1805, 0.0722, 0.9505}};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(red[k], printed[0][k], 3e-4);
        EXPECT_NEAR(green[k], printed[1][k], 3e-4);
        EXPECT_NEAR(blue[k], printed[2][k], 3e-4);
    }
}

TEST(Colour, matrices_are_inverse) {
    const Triple rgb{0.3, -0.7, 2};
    const Triple back = rgb_of_xyz(xyz_of_rgb(rgb));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(back[k], rgb[k], 1e-13);
}

TEST(Colour, response_between_points_is_linear) {
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_DOUBLE_EQ(rgb_response(555)[k], rgb_response()[195][k]);
        EXPECT_DOUBLE_EQ(rgb_response(830)[k], rgb_response()[470][k]);
        EXPECT_NEAR(rgb_response(555.25)[k],
                    0.75 * rgb_response()[195][k] + 0.25 * rgb_response()[196][k], 1e-15);
    }
}

}  // namespace
}  // namespace sunfleck::engine
