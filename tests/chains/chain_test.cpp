// Chains: uniform in their set once, they stay so, though which dimensions exist depends on the
// path.
#include "chains/chain.h"

#include "laws/toy_paths.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::Islands;
using testing_support::ToyPath;
using testing_support::ToyTally;

/// Two islands of one size.
Islands space() {
    return {"twins", {0, 6}, {{0.25, 0.15, 0.5, 1}, {0.75, 0.15, 0.5, 1}}, 1};
}

/// A sample uniform in the set of that least height, by trying.
StoredSample uniform_in_set(const Islands& islands, int least_height, RandomStream& stream) {
    while (true) {
        StoredSample sample;
        ToyPath path;
        ToyTally tally;
        islands.trace(RepeatingReader(sample, stream), path, tally);
        if (islands.height(path) >= least_height) return sample;
    }
}

/// Which of 48 parts of the visible set: 2 islands, 6 parts of each, 4 of the dimension that
/// depends on the part. Those of right halves are `open` as large as those of left halves.
std::size_t part_of(const Islands& islands, const StoredSample& sample) {
    const double u = to_unit(sample[0]);
    const std::size_t island = u < 0.5 ? 0 : 1;
    const double place = (u - (island == 0 ? 0.1 : 0.6)) / 0.3;
    const bool right = place >= 0.5;
    EXPECT_TRUE(sample.has(right ? 101 : 100));
    EXPECT_FALSE(sample.has(right ? 100 : 101)) << "not forgotten";
    const double extra = right ? to_unit(sample[101]) / islands.open : to_unit(sample[100]);
    return (island * 6 + static_cast<std::size_t>(place * 6)) * 4 +
           static_cast<std::size_t>(extra * 4);
}

// 40,000 chains of 12 steps, seed 1; chi-square at 0.1% with 47 degrees of freedom; sees parts
// that are 8% off.
TEST(Chain, uniform_in_a_set_it_stays_uniform) {
    const Islands islands = space();
    constexpr std::uint32_t kChains = 40'000;
    for (const float scale : {0.02F, 0.3F}) {
        std::array<double, 48> seen{};
        Acceptances counts;
        ToyTally tally;
        for (std::uint32_t i = 0; i < kChains; ++i) {
            RandomStream stream(1, Purpose::test, 0, i);
            const StoredSample seed = uniform_in_set(islands, kVisible, stream);
            Chain chain(islands, Target{kVisible}, seed, PassId{1, 0}.stream(Purpose::chain, i),
                        tally);
            for (int step = 0; step < 12; ++step)
                if (chain.propose({{scale, scale / 4}}, counts, tally)) chain.accept();
            ++seen.at(part_of(islands, chain.sample()));
        }
        double chi_square = 0;
        for (std::size_t part = 0; part < seen.size(); ++part) {
            const double size = part % 24 < 12 ? 1 : islands.open;
            const double expected = kChains / 24.0 * size / (1 + islands.open);
            chi_square += (seen.at(part) - expected) * (seen.at(part) - expected) / expected;
        }
        EXPECT_GT(testing_support::chi_square_p(chi_square, 47), 1e-3) << scale;
    }
}

TEST(Chain, starts_at_its_seed) {
    const Islands islands = space();
    RandomStream stream(1, Purpose::test, 0, 0);
    const StoredSample seed = uniform_in_set(islands, kVisible, stream);
    ToyTally tally;
    const Chain chain(islands, Target{kVisible}, seed, PassId{}.stream(Purpose::chain, 0), tally);
    EXPECT_EQ(chain.sample(), seed);
    EXPECT_EQ(chain.height(), kVisible);
    EXPECT_GT(chain.path().flux, 0);
    EXPECT_EQ(tally.traced, 1U);
}

// 20,000 proposals: the kinds are even within five standard errors.
TEST(Chain, counts_each_proposal_of_its_kind) {
    const Islands islands = space();
    RandomStream stream(1, Purpose::test, 0, 0);
    const StoredSample seed = uniform_in_set(islands, kVisible - 1, stream);
    ToyTally tally;
    Chain chain(islands, Target{kVisible - 1}, seed, PassId{}.stream(Purpose::chain, 0), tally);
    Acceptances counts;
    std::uint64_t accepted = 0;
    for (int i = 0; i < 20'000; ++i) {
        const StoredSample before = chain.sample();
        if (!chain.propose({{0.1F, 0.1F}}, counts, tally)) {
            EXPECT_EQ(chain.sample(), before);
            continue;
        }
        EXPECT_EQ(chain.sample(), before) << "moved before accept()";
        chain.accept();
        EXPECT_GE(chain.height(), kVisible - 1);
        EXPECT_EQ(chain.height(), islands.height(chain.path()));
        ++accepted;
    }
    EXPECT_EQ(counts[0].proposed + counts[1].proposed, 20'000U);
    EXPECT_EQ(counts[0].accepted + counts[1].accepted, accepted);
    EXPECT_NEAR(static_cast<double>(counts[0].proposed), 10'000, 354);
    EXPECT_EQ(tally.traced, 20'001U);
}

}  // namespace
}  // namespace sunfleck::engine
