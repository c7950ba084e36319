// What many scenes show together, and no scene alone.
#include "differential/shared_excess.h"

#include "core/random.h"
#include "math/vector.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine::differential {
namespace {

const FeatureTable& table() {
    static const FeatureTable two({{"light", {"spot", "sky"}, {}}, {"shape", {"box", "disk"}, {}}});
    return two;
}

double normal(RandomStream& stream) {
    const double radius = std::sqrt(-2 * std::log(1 - stream.next()));
    return radius * std::cos(2 * kPiDouble * stream.next());
}

/// Scenes of all four kinds, each as noisy as a tenth or a third of its brightness.
/// @param of_spot  what is wrong with one light.
FeatureEvidence evidence(std::uint64_t seed, int scenes, double of_spot) {
    FeatureEvidence all(table());
    RandomStream stream(seed, Purpose::test, 0, 0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(scenes); ++i) {
        const double error = i % 3 == 0 ? 0.1 : 0.03;
        const double off = i % 2 == 0 ? of_spot : 0;
        all.add({i % 2, i / 2 % 2}, {off + error * normal(stream), error});
    }
    return all;
}

TEST(SharedExcess, of_a_feature_is_found_where_each_scene_is_too_noisy_to_tell) {
    const auto faults = evidence(1, 200, 0.04).faults();
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults.front().feature, table().index_of("light"));
    EXPECT_EQ(faults.front().value, 0U);
    EXPECT_EQ(faults.front().scenes, 100U);
    EXPECT_NEAR(faults.front().excess.value, 0.04, 4 * faults.front().excess.error);
}

TEST(SharedExcess, is_no_fault_in_campaigns_that_have_none) {
    int alarms = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed)
        alarms += evidence(seed, 60, 0).faults().empty() ? 0 : 1;
    EXPECT_LE(alarms, 9);  // of 300 with 1%, 10 or more come once in 1,200
}

TEST(SharedExcess, of_a_few_scenes_is_not_judged) {
    FeatureEvidence all(table());
    for (std::size_t i = 0; i + 1 < FeatureEvidence::kFewestScenes; ++i)
        all.add({0, 0}, {1, 0.001});
    EXPECT_TRUE(all.shared().empty());
}

}  // namespace
}  // namespace sunfleck::engine::differential
