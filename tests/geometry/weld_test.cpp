// Vertices at one place.
#include "geometry/weld.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TEST(Welder, numbers_places_in_the_order_of_their_first_use) {
    Welder welder;
    EXPECT_EQ(welder.number_of({1, 2, 3}), 0U);
    EXPECT_EQ(welder.number_of({0, -0.0F, 0}), 1U);
    EXPECT_EQ(welder.number_of({1, 2, 3}), 0U);
    EXPECT_EQ(welder.number_of({-0.0F, 0, -0.0F}), 1U);
    EXPECT_EQ(welder.number_of({3, 2, 1}), 2U);
    EXPECT_EQ(welder.positions().size(), 3U);
}

/// Beyond several growths of the table.
TEST(Welder, knows_every_place_among_many) {
    Welder welder;
    constexpr int kSide = 30;
    for (int round = 0; round < 2; ++round)
        for (int i = 0; i < kSide * kSide * kSide; ++i) {
            const Vec3 p(0.1F * static_cast<float>(i % kSide),
                         0.3F * static_cast<float>(i / kSide % kSide),
                         static_cast<float>(i / kSide / kSide));
            ASSERT_EQ(welder.number_of(p), static_cast<std::uint32_t>(i));
        }
    EXPECT_EQ(welder.positions().size(), std::size_t{kSide} * kSide * kSide);
}

}  // namespace
}  // namespace sunfleck::engine
