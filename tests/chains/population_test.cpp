// Populations: survivors are drawn as often as they weigh.
#include "chains/population.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// A seed whose first dimension says which it is.
Survivor seed(std::uint64_t number, std::uint32_t units, int height = kVisible) {
    Survivor s;
    s.sample.set(0, number << 60U);
    s.units = units;
    s.height = height;
    return s;
}

/// How often each of four survivors is at one of so many even places.
std::array<int, 4> drawn(const Population& population, int places, double offset) {
    std::array<int, 4> times{};
    for (int j = 0; j < places; ++j) {
        const double place = (j + offset) * population.weight() / places;
        ++times.at(population.at(place).sample[0] >> 60U);
    }
    return times;
}

Population four() {
    Population population;
    for (const std::uint32_t units : {3U, 1U, 5U, 2U})
        population.add(seed(population.survivors().size(), units));
    return population;
}

TEST(Population, seeds_are_drawn_by_their_units) {
    const Population population = four();
    EXPECT_EQ(population.units(), 11U);
    EXPECT_EQ(population.weight(), 11);
    for (int offset = 0; offset < 8; ++offset) {
        EXPECT_EQ(drawn(population, 11, offset / 8.0), (std::array{3, 1, 5, 2}));
        EXPECT_EQ(drawn(population, 33, offset / 8.0), (std::array{9, 3, 15, 6}));
        const auto few = drawn(population, 4, offset / 8.0);
        EXPECT_EQ(few[0] + few[1] + few[2] + few[3], 4);
        EXPECT_LE(few[1], 1);
        EXPECT_LE(few[2], 2);
    }
    EXPECT_EQ(population.at(11).sample[0] >> 60U, 3U);  // the end of the line is the last seed's
}

TEST(Population, descends_from_few_independent_paths) {
    EXPECT_EQ(Population().lineages(), Lineages());
    Population population = four();
    EXPECT_EQ(population.lineages(), (Lineages{1, 1}));
    population.begin_lineages(7);
    EXPECT_EQ(population.lineages(), (Lineages{4, 5.0 / 11}));
    Survivor brother = seed(0, 4);
    brother.lineage = 9;  // that of the third
    population.add(brother);
    brother.weight = 0;
    brother.lineage = 1;
    population.add(brother);
    EXPECT_EQ(population.lineages(), (Lineages{4, 9.0 / 15}));
}

TEST(Population, those_not_high_enough_are_left_out) {
    Population population = four();
    population.add(seed(3, 7, 2));
    EXPECT_EQ(population.units(), 18U);
    EXPECT_EQ(population.at_least(3).units(), 11U);
    EXPECT_EQ(population.at_least(2).units(), 18U);
}

// The map covers the lower half of the first dimension, but its seam: the first two survivors.
TEST(Population, what_is_guided_is_left_out) {
    std::vector<WeightedEmission> starts;
    std::vector<EmissionGuide::Trial> trials;
    for (int i = 0; i < 200; ++i) {
        starts.push_back({{0.1 * i / 200, 0.5, 0.5, 0.5, 0.5}, 1});
        trials.push_back({starts.back().point, true});
    }
    const EmissionGuide map = EmissionGuide::learned(starts, {0.5}).where_visible(trials, 1e-9);
    const Population population = four();  // first dimensions 0, 1/16, 2/16, 3/16
    const GuidedPlan guided{map, 1, 0.25};
    ASSERT_TRUE(guided.reaches(population.survivors()[0].sample));
    ASSERT_FALSE(guided.reaches(population.survivors()[3].sample));
    std::uint64_t expected = 0;
    for (const Survivor& s : population.survivors())
        expected += guided.reaches(s.sample) ? 0 : s.units;
    const Population rest = four().outside(guided, 0.5);
    EXPECT_EQ(rest.units(), expected);
    EXPECT_DOUBLE_EQ(rest.weight(), 0.5 * static_cast<double>(expected));
    EXPECT_EQ(four().outside({}, 2).units(), 11U);
    EXPECT_DOUBLE_EQ(four().outside({}, 2).weight(), 22);
}

}  // namespace
}  // namespace sunfleck::engine
