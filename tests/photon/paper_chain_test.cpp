// The paper's chain on toy paths: equations 4, 5 and 9 to 11, and Fig. 3's counts.
#include "photon/paper_chain.h"

#include "laws/toy_paths.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::chi_square_p;
using testing_support::Islands;
using testing_support::ToyPath;
using testing_support::ToyTally;

struct Walk {
    explicit Walk(const PaperSettings& settings) : state(settings) {}

    PaperState state;
    std::vector<PaperStep> steps;
    double flux = 0;                // splatted
    double left = 0;                // states splatted whose flux is below 2
    std::uint64_t splatted = 0;     // states
    std::uint64_t not_visible = 0;  // of these

    std::uint64_t count(PaperStep which) const {
        return static_cast<std::uint64_t>(std::count(steps.begin(), steps.end(), which));
    }
    double mutated() const {
        return static_cast<double>(count(PaperStep::accepted) + count(PaperStep::rejected));
    }
    double acceptance() const {
        return static_cast<double>(count(PaperStep::accepted)) / mutated();
    }
};

/// Iterations of one pass after those that the walk has.
void go_on(Walk& walk, const Islands& islands, const PaperSettings& settings, PassId pass,
           std::uint32_t iterations) {
    ToyTally tally;
    const IndependentPoints points(pass);
    PaperChain<Islands> chain(islands, settings.replica_exchange, walk.state,
                              pass.stream(Purpose::chain, 0), tally);
    const auto splat = [&](const ToyPath& path, std::uint32_t steps) {
        walk.flux += path.flux * steps;
        walk.left += path.flux < 2 ? steps : 0;
        walk.splatted += steps;
        walk.not_visible += islands.height(path) == kVisible ? 0 : steps;
    };
    StoredSample read;
    ToyPath path;
    const auto take = [&](StoredSample& sample, ToyPath& to) {
        std::swap(sample, read);
        std::swap(to, path);
    };
    for (std::uint32_t i = 0; i < iterations; ++i) {
        read.clear();
        islands.trace(RecordingReader(points.path(i), read), path, tally);
        const bool visible = islands.height(path) == kVisible;
        walk.steps.push_back(chain.step(visible, take, splat, tally));
    }
    chain.finish(splat);
}

Walk walk_of(const Islands& islands, const PaperSettings& settings, std::uint32_t iterations) {
    Walk walk(settings);
    go_on(walk, islands, settings, {1, 0}, iterations);
    return walk;
}

/// A small place in six dimensions: two of every ten thousand uniform paths get there.
Islands close_up() {
    return {"close-up", {0, 1, 2, 3, 6, 7}, {{0.6, 0.05, 0.15, 1}}, 1};
}

/// Most paths are visible, as in a closed box.
Islands box() {
    return {"box", {0, 1}, {{0.3, 0.4375, 0.5, 1}}, 1};
}

/// Two places far apart, one four times the other, told apart by their flux.
Islands two_places() {
    return {"two places", {0, 1}, {{0.25, 0.02, 0.5, 0.1}, {0.75, 0.08, 0.5, 1e6}}, 1};
}

TEST(PaperChain, theta_follows_equation_11) {
    for (const double target : {0.234, 0.5}) {
        PaperSettings settings;
        settings.target_acceptance = target;
        const Walk walk = walk_of(close_up(), settings, 30'000);
        double theta = 1;
        double mutated = 0;
        double accepted = 0;
        std::uint64_t held = 0;
        for (const PaperStep step : walk.steps) {
            if (step == PaperStep::searching || step == PaperStep::exchanged) continue;
            mutated += 1;
            accepted += step == PaperStep::accepted ? 1 : 0;
            theta += (accepted / mutated - target) / mutated;
            if (theta < MutationSize::kFloor) ++held;
            theta = std::max(theta, MutationSize::kFloor);
        }
        EXPECT_GT(mutated, 10'000);
        EXPECT_EQ(walk.state.size.theta(), theta);
        EXPECT_EQ(walk.state.size.floor_held(), held);
    }
}

// 10^6 iterations, seed 1: the acceptance is by then known to 0.001.
TEST(PaperChain, acceptance_comes_to_its_target_in_a_close_up) {
    const Walk walk = walk_of(close_up(), {}, 1'010'000);
    EXPECT_GE(walk.mutated(), 1e6);
    EXPECT_NEAR(walk.acceptance(), 0.234, 0.01);
    EXPECT_LT(walk.state.size.theta(), 0.5);
}

// Table I of the paper: theta grows without end, with the logarithm of the mutations. Where it
// begins hangs on the first few.
TEST(PaperChain, theta_grows_where_most_paths_are_visible) {
    Walk walk = walk_of(box(), {}, 20'000);
    const double theta_before = walk.state.size.theta();
    const double mutated_before = walk.mutated();
    go_on(walk, box(), {}, {1, 1}, 380'000);
    EXPECT_NEAR(walk.state.visible_fraction(), box().visible_fraction(), 0.005);
    EXPECT_NEAR(walk.state.visible_fraction(), 0.7, 0.05);
    const double grown = walk.state.size.theta() - theta_before;
    const double longer = std::log(walk.mutated() / mutated_before);
    EXPECT_GT(longer, 2.9);
    EXPECT_NEAR(grown, (walk.acceptance() - 0.234) * longer, 0.05);
    EXPECT_GT(grown, 1);
    EXPECT_GT(walk.state.size.theta(), 4);
}

TEST(PaperChain, theta_has_a_floor) {
    MutationSize size{{}};
    double printed = 1;
    for (int i = 1; i <= 100; ++i) {
        size.count_mutation(false);
        printed -= 0.234 / i;
    }
    EXPECT_LT(printed, 0);
    EXPECT_EQ(size.theta(), MutationSize::kFloor);
    EXPECT_GT(size.floor_held(), 40U);
    const std::uint64_t held = size.floor_held();
    for (int i = 0; i < 200; ++i) size.count_mutation(true);
    EXPECT_GT(size.theta(), 0.1);
    EXPECT_LT(size.floor_held(), held + 60);
}

TEST(PaperChain, a_fixed_size_stays) {
    PaperSettings settings;
    settings.mutation_size = 0.01;
    const Walk walk = walk_of(close_up(), settings, 20'000);
    EXPECT_EQ(walk.state.size.theta(), 0.01);
    EXPECT_EQ(walk.state.size.floor_held(), 0U);
    EXPECT_GT(walk.acceptance(), 0.8);  // tiny steps
}

// 200,000 steps for each theta; chi-square at 0.1% with 49 and 1 degrees of freedom; sees bins
// that are 3% off.
TEST(PaperStep, has_the_law_of_equation_9) {
    constexpr int kSteps = 200'000;
    constexpr std::uint64_t kFrom = 0x0123456789ABCDEF;
    RandomStream stream(1, Purpose::test, 0, 0);
    RandomStream again = stream;
    for (const double theta : {0.3, 1.0, 4.0}) {
        std::array<double, 50> bins{};
        double up = 0;
        PaperMove move(theta, stream);
        for (int i = 0; i < kSteps; ++i) {
            const std::uint64_t to = move(0, kFrom);
            const std::uint64_t random = again.next_fraction();
            const bool is_up = (random & 1U) != 0;
            const double size = to_unit(is_up ? to - kFrom : kFrom - to);
            up += is_up ? 1 : 0;
            ++bins.at(static_cast<std::size_t>(50 * std::pow(size, 1 / (1 / theta + 1))));
            const auto exponent = static_cast<float>(1 / theta + 1);
            EXPECT_EQ(paper_step(kFrom, exponent, random ^ 1U) - kFrom, kFrom - to) << "symmetric";
        }
        double chi_square = 0;
        for (const double n : bins) chi_square += (n - kSteps / 50.0) * (n - kSteps / 50.0);
        EXPECT_GT(chi_square_p(chi_square * 50 / kSteps, 49), 1e-3) << theta;
        const double half = kSteps / 2.0;
        EXPECT_GT(chi_square_p(2 * (up - half) * (up - half) / half, 1), 1e-3) << theta;
    }
}

// 200,000 steps at the floor of theta; chi-square at 0.1% with 20 degrees of freedom. The first bin
// has the steps below 2^-52 of an event, of which most are no step at all.
TEST(PaperStep, has_the_law_of_equation_9_at_the_floor) {
    constexpr int kSteps = 200'000;
    constexpr std::uint64_t kFrom = 0x0123456789ABCDEF;
    const auto exponent = static_cast<float>(1 / MutationSize::kFloor + 1);
    const double smallest = std::pow(0x1p-52, 1 / double{exponent});
    RandomStream stream(1, Purpose::test, 1, 0);
    std::array<double, 21> bins{};
    double still = 0;
    for (int i = 0; i < kSteps; ++i) {
        const std::uint64_t random = stream.next_fraction() | 1U;
        const std::uint64_t step = paper_step(kFrom, exponent, random) - kFrom;
        EXPECT_EQ(paper_step(kFrom, exponent, random ^ 1U), kFrom - step) << "symmetric";
        still += step == 0 ? 1 : 0;
        const double xi = std::pow(to_unit(step), 1 / double{exponent});
        const double place = 20 * (xi - smallest) / (1 - smallest);
        ++bins.at(place < 0 ? 0 : 1 + static_cast<std::size_t>(place));
    }
    double chi_square = 0;
    for (std::size_t i = 0; i < bins.size(); ++i) {
        const double expected = kSteps * (i == 0 ? smallest : (1 - smallest) / 20);
        chi_square += (bins[i] - expected) * (bins[i] - expected) / expected;
    }
    EXPECT_GT(chi_square_p(chi_square, 20), 1e-3);
    EXPECT_NEAR(still / kSteps, std::pow(0x1p-64, 1 / double{exponent}), 0.002);
}

TEST(PaperStep, wraps_around_at_both_ends) {
    constexpr std::uint64_t kHalf = std::uint64_t{1} << 63U;
    const std::uint64_t down = kHalf;  // xi = 1/2, to the lower side
    const std::uint64_t up = kHalf | 1U;
    constexpr double kOne = 0x1p64;
    const auto as_turns = [&](std::uint64_t dimension) {
        return static_cast<double>(dimension) / kOne;
    };
    EXPECT_NEAR(as_turns(paper_step(kHalf / 4, 1, down)), 0.125 + 1 - 0.5, 1e-6);
    EXPECT_NEAR(as_turns(paper_step(kHalf / 4 * 7, 1, up)), 0.875 - 0.5, 1e-6);
    EXPECT_NEAR(as_turns(paper_step(kHalf / 4, 2, down)), 0.125 + 1 - 0.25, 1e-6);
}

TEST(PaperChain, counts_are_those_of_figure_3) {
    const Islands islands = close_up();
    const Walk walk = walk_of(islands, {}, 100'000);
    const std::uint64_t searching = walk.count(PaperStep::searching);
    EXPECT_GT(searching, 0U);
    EXPECT_EQ(walk.steps.front(), PaperStep::searching);
    EXPECT_EQ(walk.state.uniform, 100'000U);
    EXPECT_EQ(walk.state.uniform_visible, walk.count(PaperStep::exchanged));
    EXPECT_EQ(walk.state.splatted, 100'000 - searching);
    EXPECT_EQ(walk.splatted, walk.state.splatted);
    EXPECT_EQ(walk.not_visible, 0U);
    for (std::size_t i = searching; i < walk.steps.size(); ++i)
        ASSERT_NE(walk.steps[i], PaperStep::searching) << "once found, never lost";
}

// 400,000 iterations, seed 1: the mean splatted flux is known to 1% (chains of some ten states).
TEST(PaperChain, splats_what_uniform_paths_bring) {
    const Islands islands = box();
    const Walk walk = walk_of(islands, {}, 400'000);
    const double estimate =
        walk.state.visible_fraction() * walk.flux / static_cast<double>(walk.splatted);
    EXPECT_NEAR(estimate / islands.mean_flux(), 1, 0.01);
}

// 300,000 iterations: some 27,000 exchanges, so the share is known to 0.01. Of the mutations of so
// small a theta less than one in 10^5 goes far enough.
TEST(PaperChain, replica_exchange_alone_reaches_both_places) {
    PaperSettings settings;
    settings.mutation_size = 1e-6;
    const Walk with = walk_of(two_places(), settings, 300'000);
    EXPECT_NEAR(with.left / static_cast<double>(with.splatted), 0.2, 0.03);

    settings.replica_exchange = false;
    const Walk without = walk_of(two_places(), settings, 300'000);
    EXPECT_EQ(without.count(PaperStep::exchanged), 1U) << "the first path alone";
    EXPECT_EQ(without.state.uniform_visible, with.state.uniform_visible) << "all are counted";
    const double share = without.left / static_cast<double>(without.splatted);
    EXPECT_TRUE(share == 0 || share == 1) << share;
}

/// The next pass begins with the path of the last one, seen or not, and with all counts.
TEST(PaperChain, goes_on_where_the_view_has_moved) {
    const PaperSettings settings;
    Walk walk(settings);
    Islands islands = close_up();
    go_on(walk, islands, settings, {1, 0}, 20'000);
    ASSERT_TRUE(walk.state.found);
    const double theta = walk.state.size.theta();
    const std::uint64_t visible = walk.state.uniform_visible;
    islands.islands[0].centre = 0.1;
    Walk moved = walk;
    go_on(moved, islands, settings, {1, 1}, 1);
    EXPECT_EQ(moved.steps.back(), PaperStep::rejected);
    EXPECT_EQ(moved.not_visible, 1U) << "splatted, in vain";
    EXPECT_EQ(moved.state.uniform, 20'001U);
    EXPECT_EQ(moved.state.uniform_visible, visible);
    EXPECT_NE(moved.state.size.theta(), theta);
    EXPECT_EQ(moved.state.current, walk.state.current);
}

}  // namespace
}  // namespace sunfleck::engine
