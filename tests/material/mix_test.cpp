// Mixed materials: how often each part is met, and that a place always meets the same.
#include "core/random.h"
#include "material/material.h"

#include <gtest/gtest.h>

namespace sunfleck {
namespace {

TexturePoint somewhere(RandomStream& random) {
    return {Vec3(random.next_float(), random.next_float(), random.next_float()), {0, 0, 1}, {0, 0}};
}

/// 100,000 places: one standard error of a share is 0.0016 at most.
TEST(Mix, parts_are_met_by_their_amount) {
    constexpr int kPlaces = 100'000;
    for (const float amount : {0.0F, 0.2F, 0.5F, 1.0F}) {
        const MixMaterial mix{{3, 8}, amount};
        RandomStream random(1, Purpose::test, 0, 0);
        int second = 0;
        for (int i = 0; i < kPlaces; ++i) {
            const TexturePoint place = somewhere(random);
            const std::uint32_t part = mix.chosen(place);
            ASSERT_TRUE(part == 3 || part == 8);
            EXPECT_EQ(mix.chosen(place), part);
            second += part == 8 ? 1 : 0;
        }
        const double share = static_cast<double>(second) / kPlaces;
        EXPECT_NEAR(share, amount, amount == 0 || amount == 1 ? 0 : 0.007) << amount;
    }
}

/// Two mixes at one place choose each for itself.
TEST(Mix, of_other_parts_choose_otherwise) {
    const MixMaterial a{{1, 2}, 0.5F};
    const MixMaterial b{{3, 4}, 0.5F};
    RandomStream random(2, Purpose::test, 0, 0);
    int both = 0;
    for (int i = 0; i < 10'000; ++i) {
        const TexturePoint place = somewhere(random);
        both += a.chosen(place) == 2 && b.chosen(place) == 4 ? 1 : 0;
    }
    EXPECT_NEAR(both, 2500, 200);
}

}  // namespace
}  // namespace sunfleck
