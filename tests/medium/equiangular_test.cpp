// Distances by angle: their density is that of what is drawn, and has the integral one.
#include "medium/equiangular.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

struct WayPast {
    Ray way;
    Vec3 point;
};

class EquiangularDistances : public testing::TestWithParam<WayPast> {};

TEST_P(EquiangularDistances, have_the_density_that_is_said) {
    const Equiangular distances(GetParam().way, GetParam().point);
    constexpr int kParts = 200;
    float before = distances.distance_at(0);
    EXPECT_NEAR(before, 0, 1e-5F);
    for (int i = 1; i < kParts; ++i) {
        const float here = distances.distance_at(static_cast<float>(i) / kParts);
        ASSERT_GT(here, before);
        ASSERT_LE(here, GetParam().way.length);
        // Simpson's rule over a part, which holds one in kParts.
        const float step = here - before;
        const float share = step / 6 *
                            (distances.density(before) + 4 * distances.density(before + step / 2) +
                             distances.density(here));
        if (i > 1 && i + 1 < kParts) {
            EXPECT_NEAR(share * kParts, 1, 0.02F) << i;
        }
        before = here;
    }
}

INSTANTIATE_TEST_SUITE_P(All, EquiangularDistances,
                         testing::Values(WayPast{{Vec3(0), Vec3(0, 0, 1), 4}, {1, 0, 2}},
                                         WayPast{{Vec3(1, 2, 3), Vec3(1, 0, 0), 5}, {-1, 2, 3.5F}},
                                         WayPast{{Vec3(0), Vec3(0, 1, 0), kInfinity}, {0, 3, 1}},
                                         WayPast{{Vec3(0), Vec3(0, 1, 0), 2}, {0.3F, 9, 0}}));

/// A point on the way itself: no density is infinite.
TEST(Equiangular, bears_a_point_on_its_way) {
    const Equiangular distances({Vec3(0), Vec3(0, 0, 1), 4}, {0, 0, 2});
    EXPECT_TRUE(std::isfinite(distances.density(2)));
    EXPECT_NEAR(distances.distance_at(0.5F), 2, 0.01F);
}

}  // namespace
}  // namespace sunfleck::engine
