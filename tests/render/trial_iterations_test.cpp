// Views of trials are independent: their camera paths are of different nets.
#include "planning/trial_iterations.h"

#include "chains/chain_walk.h"
#include "random_numbers/batch_points.h"

#include <gtest/gtest.h>

#include <set>

namespace sunfleck::engine {
namespace {

TEST(TrialIterations, of_views_stand_in_blocks_of_their_own) {
    for (const std::uint32_t epoch : {0U, 1U, 5U}) {
        const PilotName name{7, epoch};
        std::set<std::uint32_t> blocks;
        for (const std::uint32_t iteration :
             {kExploredTrialIteration, kSecondTrialIteration, kPixelTrialsIteration})
            blocks.insert(name.iteration(iteration).number / kBatchPasses);
        EXPECT_EQ(blocks.size(), 3U) << epoch;
    }
}

// Covariance over 4096 pixels: by chance 0 +- .0013 (one standard error, seed 7). Neighbours in a
// net lie in opposite halves: -1/16.
TEST(TrialIterations, of_views_have_points_that_know_nothing_of_each_other) {
    const PilotName name{7, 1};
    const auto point = [&](std::uint32_t iteration, std::uint32_t pixel) {
        return BatchPoints(name.iteration(iteration), pixel).next() - 0.5;
    };
    const auto covariance = [&](std::uint32_t one, std::uint32_t other) {
        double sum = 0;
        for (std::uint32_t pixel = 0; pixel < 4096; ++pixel)
            sum += point(one, pixel) * point(other, pixel);
        return sum / 4096;
    };
    EXPECT_NEAR(covariance(kExploredTrialIteration, kExploredTrialIteration + 1), -1.0 / 16, 0.004)
        << "of one net";
    EXPECT_NEAR(covariance(kExploredTrialIteration, kSecondTrialIteration), 0, 0.004);
    EXPECT_NEAR(covariance(kExploredTrialIteration, kPixelTrialsIteration), 0, 0.004);
    EXPECT_NEAR(covariance(kSecondTrialIteration, kPixelTrialsIteration), 0, 0.004);
}

}  // namespace
}  // namespace sunfleck::engine
