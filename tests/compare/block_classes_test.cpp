// Errors by blocks and classes, against values computed by hand.
#include "compare/block_classes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

TEST(BlockClasses, the_mean_of_a_block_is_that_of_its_pixels) {
    constexpr std::size_t kWidth = 20;  // two blocks and a rest
    std::vector<double> pixels(kWidth * 9, 1000);
    for (std::size_t y = 0; y < 8; ++y)
        for (std::size_t x = 0; x < 16; ++x) pixels[y * kWidth + x] = x < 8 ? double(y) : double(x);
    const std::vector<double> means = block_means(pixels, kWidth);
    ASSERT_EQ(means.size(), 2U);
    EXPECT_DOUBLE_EQ(means[0], 3.5);
    EXPECT_DOUBLE_EQ(means[1], 11.5);
}

/// Ten blocks whose mean is one.
TEST(BlockClasses, a_block_belongs_to_the_class_of_its_brightness) {
    const std::vector<double> brightness = {0, 0.01, 0.02, 0.05, 0.1, 0.3, 0.5, 1, 1.5, 6.52};
    const BlockClasses classes(brightness);
    using List = std::vector<std::size_t>;
    EXPECT_EQ(classes.blocks(0), (List{0, 1}));
    EXPECT_EQ(classes.blocks(1), (List{2, 3}));
    EXPECT_EQ(classes.blocks(2), (List{4, 5}));
    EXPECT_EQ(classes.blocks(3), (List{6, 7, 8, 9}));
    EXPECT_NEAR(classes.mean(1), 0.035, 1e-12);
    EXPECT_NEAR(classes.mean(3), 2.38, 1e-12);
}

/// Forty blocks of one class: the worst two are left out of the trimmed error.
TEST(BlockClasses, the_trimmed_error_leaves_out_the_worst_twentieth) {
    ReferenceBlocks reference{std::vector<double>(40, 2), std::vector<double>(40, 0)};
    const BlockClasses classes(reference.mean);
    std::vector<double> blocks(40, 2.2);
    blocks[7] = 12;
    blocks[31] = 22;
    const ClassError error = class_errors(classes, reference, blocks)[3];
    EXPECT_NEAR(error.plain, (38 * 0.04 + 100 + 400) / 40 / 4, 1e-12);
    EXPECT_NEAR(error.trimmed, 0.04 / 4, 1e-12);
}

TEST(BlockClasses, the_variance_of_the_reference_is_taken_off) {
    ReferenceBlocks reference{{1, 1}, {0.01, 0.03}};
    const BlockClasses classes(reference.mean);
    const std::vector<double> blocks = {1.2, 1};
    EXPECT_NEAR(class_errors(classes, reference, blocks)[3].plain, 0, 1e-12);
    EXPECT_NEAR(relative_square_error(reference, {1.4, 1}), (0.15 - 0.03) / 2 / 1.01, 1e-12);
}

/// An AOV is measured by the classes, and over the brightness, of all light.
TEST(BlockClasses, an_aov_is_measured_over_the_brightness_of_all_light) {
    const BlockClasses classes({10, 10, 0.5, 0.5});
    const ReferenceBlocks aov{{0, 0, 0.1, 0.1}, {0, 0, 0, 0}};
    const auto errors = class_errors(classes, aov, {0, 0, 0.2, 0.1});
    EXPECT_NEAR(errors[1].plain, 0.01 / 2 / 0.25, 1e-12);
    EXPECT_EQ(errors[3].plain, 0);
    EXPECT_EQ(errors[0].plain, 0);  // no block
}

}  // namespace
}  // namespace sunfleck::engine
