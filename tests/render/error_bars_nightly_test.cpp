// Error bars of the default sampler on close-ups: what blocks report against their true spread.
//
// 64 renders of 8 batches each of cognac-2 and cognac-5, few paths a pass so that a splitting of
// some sets is at work. The ratio of both standard errors, pooled over 16 blocks that share their
// brightness's error: its own standard error is between 2 and 9%; within 15%.
#include "support/films.h"
#include "support/procedural.h"
#include "support/spread.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

class ErrorBars : public testing::TestWithParam<std::string> {};

TEST_P(ErrorBars, of_blocks_are_their_true_spread) {
    constexpr int kSeeds = 64;
    constexpr std::uint32_t kBatches = 8;
    constexpr int kSize = 32;
    const Scene scene = procedural(GetParam(), kSize);
    RenderSettings settings;
    settings.photon.paths_per_pass = 20'000;
    std::vector<Spread> blocks;
    for (int seed = 0; seed < kSeeds; ++seed) {
        settings.seed = static_cast<std::uint64_t>(seed);
        const std::vector<MeanError> errors =
            block_errors(film_of_batches(scene, settings, kBatches));
        blocks.resize(errors.size());
        for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i].add(errors[i]);
    }
    double ratio = 0;
    for (const Spread& block : blocks) ratio += block.reported() / block.spread();
    EXPECT_NEAR(std::sqrt(ratio / static_cast<double>(blocks.size())), 1, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ErrorBars, testing::Values("cognac-2", "cognac-5"),
                         [](const auto& info) {
                             return "cognac_" + info.param.substr(info.param.size() - 1);
                         });

}  // namespace
}  // namespace sunfleck::engine
