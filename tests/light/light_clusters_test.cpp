// Clusters of lights: every lit light in one of them, the strong ones alone.
#include "light/light_clusters.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using Clusters = std::vector<std::vector<std::uint32_t>>;

TEST(LightClusters, few_sources_are_a_cluster_each) {
    const LightChoice weights({1, 2, 0, 3, 4});
    const std::vector<LightRange> sources = {{0, 2}, {2, 1}, {3, 1}, {4, 1}};
    EXPECT_EQ(light_clusters(sources, weights, 4), (Clusters{{0, 1}, {3}, {4}}));
    EXPECT_TRUE(light_clusters({}, LightChoice(), 4).empty());
    EXPECT_TRUE(light_clusters({{0, 1}}, LightChoice({0}), 4).empty());
}

TEST(LightClusters, of_many_the_strongest_stand_alone_and_neighbours_together) {
    std::vector<double> powers(20, 1.0);
    powers[7] = 100;
    powers[13] = 50;
    std::vector<LightRange> sources;
    for (std::uint32_t i = 0; i < 20; ++i) sources.push_back({i, 1});
    const Clusters clusters = light_clusters(sources, LightChoice(powers), 4);
    ASSERT_EQ(clusters.size(), 4U);
    EXPECT_EQ(clusters[0], std::vector<std::uint32_t>{7});
    EXPECT_EQ(clusters[1], std::vector<std::uint32_t>{13});
    EXPECT_EQ(clusters[2], (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 8, 9}));
    EXPECT_EQ(clusters[3], (std::vector<std::uint32_t>{10, 11, 12, 14, 15, 16, 17, 18, 19}));
}

TEST(LightChoice, among_some_lights_keeps_their_odds) {
    const LightChoice some = LightChoice({1, 2, 3, 4}).among({1, 3});
    EXPECT_EQ(some.probability(0), 0);
    EXPECT_NEAR(some.probability(1), 1.0 / 3, 1e-12);
    EXPECT_EQ(some.probability(2), 0);
    EXPECT_NEAR(some.probability(3), 2.0 / 3, 1e-12);
    EXPECT_NEAR(some.total(), 6, 1e-12);
    for (const double u : {0.01, 0.3, 0.34, 0.99})
        EXPECT_EQ(some.choose(u).index, u < 1.0 / 3 ? 1U : 3U);
    EXPECT_TRUE(LightChoice({1, 2}).among({}).empty());
}

}  // namespace
}  // namespace sunfleck::engine
