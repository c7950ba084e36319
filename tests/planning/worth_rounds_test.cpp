// Rounds of trials of different guides and sizes are one sample.
#include "planning/worth_rounds.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kVisible8th = 1;

/// Of the eighths of the first dimension, the second brings three times what the first brings, and
/// others bring nothing.
double light_at(const EmissionPoint& at) {
    const auto eighth = static_cast<std::size_t>(at[0] * 8);
    if (eighth > kVisible8th) return 0;
    return eighth == kVisible8th ? 3 : 1;
}

class WorthRoundsTest : public testing::Test {
protected:
    PathTrials trials(const EmissionGuide& guide, std::uint32_t count) {
        PathTrials trials;
        for (std::uint32_t path = 0; path < count; ++path) {
            EmissionPoint u;
            for (double& x : u) x = random_.next();
            trials.points.push_back(guide(u).point);
            const double light = light_at(trials.points.back());
            if (light > 0) trials.light.push_back({path, 0, light});
        }
        return trials;
    }

    std::vector<WeightedEmission> casters() {
        std::vector<WeightedEmission> samples;
        for (int i = 0; i < 1000; ++i) {
            WeightedEmission sample{{}, 5};
            for (double& x : sample.point) x = random_.next();
            sample.point[0] /= 2;
            samples.push_back(sample);
        }
        return samples;
    }

    /// Returns the worth of the second eighth over that of the first.
    static double ratio(const WorthRounds::Advice& advice) {
        std::array<double, 2> sums{};
        for (const WorthRounds::Part& part : advice.parts)
            sums.at(static_cast<std::size_t>(part.point[0] * 8)) += part.weight;
        return sums[1] / sums[0];
    }

    WorthRounds::Advice advice(const WorthRounds& rounds, double over_casters = 0.1) const {
        return rounds.advice({blocks_, unlit_, Objective::relative}, over_casters);
    }

private:
    RandomStream random_{1, Purpose::test, 0, 0};
    BlockGrid blocks_{8, 8, 8};
    std::vector<double> unlit_ = {64};
};

TEST_F(WorthRoundsTest, begin_with_samples_of_casters) {
    EXPECT_TRUE(WorthRounds(std::vector<WeightedEmission>()).are_idle());
    const WorthRounds rounds(casters());
    EXPECT_FALSE(rounds.are_idle());
    EXPECT_FALSE(rounds.have_found());
    const EmissionGuide guide = advice(rounds).guide;
    EXPECT_GT(guide.density({0.2, 0.5, 0.5, 0.5, 0.5}),
              5 * guide.density({0.8, 0.5, 0.5, 0.5, 0.5}));
}

TEST_F(WorthRoundsTest, of_different_guides_and_sizes_are_one_sample) {
    WorthRounds rounds(casters());
    const EmissionGuide identity;
    const std::size_t found = rounds.add(identity, trials(identity, 8000));
    EXPECT_NEAR(static_cast<double>(found), 2000, 4 * std::sqrt(1500));
    EXPECT_NEAR(ratio(advice(rounds)), 3, 0.3);
    const EmissionGuide guide = advice(rounds).guide;
    // Three times the light asks for three times the paths, less what each place has anyway.
    EXPECT_NEAR(
        guide.density({0.19, 0.5, 0.5, 0.5, 0.5}) / guide.density({0.06, 0.5, 0.5, 0.5, 0.5}), 2.7,
        0.3);
    rounds.add(guide, trials(guide, 40'000));
    EXPECT_NEAR(ratio(advice(rounds)), 3, 0.1);
    // Places of casters that have brought nothing keep a tenth of the paths, twice as dense as
    // uniform ones, beside what the tree leaves them.
    const EmissionPoint unlit{0.4, 0.5, 0.5, 0.5, 0.5};
    EXPECT_GT(advice(rounds).guide.density(unlit), 0.3);
    EXPECT_GT(advice(rounds, 0.3).guide.density(unlit), advice(rounds).guide.density(unlit) + 0.3);
}

}  // namespace
}  // namespace sunfleck::engine
