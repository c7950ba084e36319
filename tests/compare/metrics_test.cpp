// Metrics against values computed by hand.
#include "compare/metrics.h"

#include "compare/pictures.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::picture;
using testing_support::plain;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Metrics, of_equal_pictures_are_the_best_there_are) {
    const RgbImage image = picture([](int x, int y, int c) { return 0.1F * float(x + y + c); });
    const Metrics metrics = measure(image, image).metrics;
    for (const MetricRow& row : kMetrics) EXPECT_EQ(metrics.*row.value, row.best) << row.title;
}

/// Two pixels: the first differs by 1/2 in red, the second by 2 in all.
TEST(Metrics, are_the_means_of_their_formulas) {
    const RgbImage reference{2, 1, {Vec3(1, 0, 0), Vec3(2, 2, 2)}};
    const RgbImage test{2, 1, {Vec3(0.5F, 0, 0), Vec3(4, 4, 4)}};
    const Metrics m = measure(reference, test).metrics;
    EXPECT_NEAR(m.mse, (0.25 + 3 * 4) / 6, 1e-12);
    EXPECT_NEAR(m.rel_mse, (0.25 / 1.01 + 3 * 4 / 4.01) / 6, 1e-12);
    EXPECT_NEAR(m.smape, (0.5 / 1.51 + 3 * 2 / 6.01) / 6, 1e-12);
    EXPECT_NEAR(m.luminance_ratio, (0.1063 + 4) / (0.2126 + 2), 1e-6);
}

/// A constant factor k on a constant c: mse = c^2 (k-1)^2, and so on.
TEST(Metrics, of_a_brighter_picture_have_closed_forms) {
    const double c = 0.5;
    const double k = 1.5;
    const Metrics m = measure(plain(Vec3(0.5F)), plain(Vec3(0.75F))).metrics;
    EXPECT_NEAR(m.mse, c * c * (k - 1) * (k - 1), 1e-12);
    EXPECT_NEAR(m.rel_mse, c * c * (k - 1) * (k - 1) / (c * c + 0.01), 1e-12);
    EXPECT_NEAR(m.smape, c * (k - 1) / (c * (k + 1) + 0.01), 1e-12);
    EXPECT_NEAR(m.luminance_ratio, k, 1e-6);
}

TEST(Metrics, leave_out_what_is_not_finite_in_one_of_the_two) {
    RgbImage reference = plain(Vec3(0.5F));
    RgbImage test = plain(Vec3(0.75F));
    const Metrics whole = measure(reference, test).metrics;
    test.pixels[5].y = kNan;
    test.pixels[6].x = kInfinity;
    reference.pixels[40].z = -kInfinity;
    test.pixels[40].z = kNan;
    const Measured holes = measure(reference, test);
    EXPECT_EQ(holes.left_out, 3U);
    EXPECT_EQ(broken_pixels(test), 3U);
    EXPECT_EQ(broken_pixels(reference), 1U);
    EXPECT_NEAR(holes.metrics.mse, whole.mse, 1e-12);
    EXPECT_NEAR(holes.metrics.rel_mse, whole.rel_mse, 1e-12);
    EXPECT_NEAR(holes.metrics.smape, whole.smape, 1e-12);
    EXPECT_NEAR(holes.metrics.luminance_ratio, whole.luminance_ratio, 1e-9);
    EXPECT_EQ(holes.flip_map[5], 0);
    EXPECT_GT(holes.flip_map[100], 0);
    EXPECT_LT(holes.metrics.flip, 1);  // and is a number
}

TEST(Metrics, of_pictures_without_a_finite_pixel_have_no_value) {
    const Measured none = measure(plain(Vec3(kNan)), plain(Vec3(1)));
    for (const MetricRow& row : kMetrics) EXPECT_TRUE(std::isnan(none.metrics.*row.value));
    EXPECT_EQ(none.left_out, none.flip_map.size());
}

TEST(Metrics, of_a_black_reference_have_no_ratio) {
    const Metrics m = measure(plain(Vec3(0)), plain(Vec3(1))).metrics;
    EXPECT_TRUE(std::isnan(m.luminance_ratio));
    EXPECT_TRUE(std::isnan(m.hdr_flip));
    EXPECT_NEAR(m.rel_mse, 100, 1e-9);
}

}  // namespace
}  // namespace sunfleck::engine
