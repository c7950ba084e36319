// The radius schedule: a function of the pass number, falling as theory asks.
#include "visible_points/radius.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

constexpr double kAlpha = 2.0 / 3;

/// The product of (k + a) / (k + 1), k = 1 .. p, in closed form by the gamma function.
TEST(RadiusSchedule, is_the_product_of_knaus_and_zwicker) {
    for (const double alpha : {0.1, kAlpha, 0.95}) {
        EXPECT_EQ(radius_factor(0, alpha), 1);
        for (const std::uint32_t pass : {1U, 2U, 3U, 10U, 100U}) {
            const double product =
                std::tgamma(pass + 1 + alpha) / std::tgamma(1 + alpha) / std::tgamma(pass + 2.0);
            EXPECT_NEAR(std::pow(radius_factor(pass, alpha), 2), product, 1e-10 * product) << pass;
        }
    }
}

TEST(RadiusSchedule, one_step_is_the_published_ratio) {
    for (std::uint32_t pass = 1; pass < 50; ++pass) {
        const double ratio = radius_factor(pass, kAlpha) / radius_factor(pass - 1, kAlpha);
        EXPECT_NEAR(ratio * ratio, (pass + kAlpha) / (pass + 1.0), 1e-12);
    }
}

/// r^2 falls like p^(alpha - 1): variance of the mean and bias both vanish.
TEST(RadiusSchedule, squared_radius_falls_like_a_power) {
    for (const double alpha : {0.3, kAlpha, 0.9}) {
        const double ratio = radius_factor(100'000, alpha) / radius_factor(1'000, alpha);
        EXPECT_NEAR(2 * std::log(ratio) / std::log(100.0), alpha - 1, 1e-3);
    }
}

}  // namespace
}  // namespace sunfleck::engine
