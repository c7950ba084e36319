// Noise: values worked out apart from this program by the published formula, and its properties.
#include "texture/noise.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace sunfleck::engine {
namespace {

TEST(Noise, has_the_published_values) {
    EXPECT_NEAR(noise({0.5F, 0.5F, 0.5F}), -0.125F, 1e-6F);
    EXPECT_NEAR(noise({1.3F, 2.7F, -0.4F}), -0.11022378F, 1e-5F);
    EXPECT_NEAR(noise({-7.25F, 100.125F, 3.9F}), 0.41254401F, 1e-5F);
    EXPECT_NEAR(noise({255.5F, -0.25F, 511.75F}), -0.32993937F, 1e-5F);
    EXPECT_NEAR(noise({12.1F, 13.2F, 14.3F}), 0.37978690F, 1e-5F);
}

TEST(Noise, is_zero_at_whole_numbers_and_repeats) {
    for (const Vec3& p : {Vec3(0), Vec3(1, -5, 77), Vec3(256, 255, -256)})
        EXPECT_EQ(noise(p), 0) << p;
    const Vec3 p(3.25F, -8.5F, 0.75F);
    EXPECT_EQ(noise(p), noise(p + Vec3(256, 0, 0)));
    EXPECT_EQ(noise(p), noise(p + Vec3(0, -512, 256)));
}

TEST(Noise, is_smooth_and_bounded) {
    RandomStream random(1, Purpose::test, 0, 0);
    float least = 0;
    float most = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p(20 * random.next_float(), 20 * random.next_float(), 20 * random.next_float());
        const float value = noise(p);
        least = std::min(least, value);
        most = std::max(most, value);
        EXPECT_NEAR(noise(p + Vec3(1e-3F, 0, 0)), value, 5e-3F);
    }
    EXPECT_GE(least, -1.05F);
    EXPECT_LE(most, 1.05F);
    EXPECT_LT(least, -0.6F);
    EXPECT_GT(most, 0.6F);
}

TEST(Noise, of_numbers_that_are_none_is_finite) {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float x : {infinity, -infinity, std::numeric_limits<float>::quiet_NaN(), 1e30F})
        EXPECT_TRUE(std::isfinite(noise({x, 0.5F, x})));
}

TEST(Noise, sums_over_octaves) {
    EXPECT_NEAR(fbm({0.5F, 0.5F, 0.5F}, {8, 0.5F}), -0.11803758F, 1e-5F);
    EXPECT_NEAR(fbm({1.3F, 2.7F, -0.4F}, {3, 0.3F}), -0.03731116F, 1e-5F);
    EXPECT_NEAR(turbulence({0.5F, 0.5F, 0.5F}, {8, 0.5F}), 0.18843222F, 1e-5F);
    EXPECT_NEAR(turbulence({1.3F, 2.7F, -0.4F}, {8, 0.5F}), 0.47627202F, 1e-4F);
    EXPECT_EQ(fbm({0.5F, 0.5F, 0.5F}, {0, 0.5F}), 0);
}

}  // namespace
}  // namespace sunfleck::engine
