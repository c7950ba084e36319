// Pilots: what they learn of spaces whose sets are known.
#include "chains/pilot.h"

#include "core/parallel.h"
#include "laws/toy_paths.h"
#include "random_numbers/emission_points.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using testing_support::first_dimensions;
using testing_support::Islands;

constexpr std::uint32_t kPaths = 200'000;

struct Nowhere {
    struct Collector {
        void operator()(const Islands::Path&, double) {}
    };
    Collector make() { return {}; }
    void take(std::vector<Collector>&&) {}
};

/// What is visible elsewhere is only nearly visible here.
struct Dark : Islands {
    int height(const Path& path) const { return std::min(path.height, kVisible - 1); }
};

/// All read what maps are made of. Visible fractions from 4e-3 down to 1e-7.
std::vector<Islands> spaces() {
    return {
        {"two slots", {0, 6, 1, 2, 3, 4}, {{0.25, 0.02, 0.5, 1}, {0.7, 0.03, 0.5, 8}}},
        {"eight slots", first_dimensions(8), {{0.3, 0.01, 0.45, 1}, {0.7, 0.02, 0.4, 5}}},
        {"64 slots", first_dimensions(64), {{0.25, 0.005, 0.495, 1}, {0.8, 0.005, 0.49, 3}}},
        {"1e-7", {0, 6, 1, 2, 3, 4}, {{0.3, 1.5e-4, 0.5, 1}, {0.7, 0.8e-4, 0.5, 5}}},
    };
}

PilotResult learn(const Islands& space, std::uint64_t seed) {
    return Pilot<Islands, EmissionPoints>(space, {seed, 0}).run(kPaths);
}

// The pilot picks its sets by what it sees, so it finds a little too much; the mean of six
// survivors has a standard error of up to 20%.
TEST(Pilot, finds_how_rare_visible_paths_are) {
    for (const Islands& space : spaces()) {
        double mean = 0;
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            const double ratio = learn(space, seed).tail[kVisible] / space.visible_fraction();
            EXPECT_GT(ratio, 1 / 3.0) << space.name;
            EXPECT_LT(ratio, 3) << space.name;
            mean += ratio / 6;
        }
        EXPECT_GT(mean, 1 / 1.5) << space.name;
        EXPECT_LT(mean, 1.5) << space.name;
    }
}

// Acceptance of a full pass with what was learned, by level and kind, at seed 1. Of what a guide
// leaves out, which may be slivers, scales are learned less well.
TEST(Pilot, learns_scales_that_accept_as_often_as_asked) {
    int alone = 0;
    for (const Islands& space : spaces()) {
        const PilotResult result = learn(space, 1);
        const PassId pass{1, 0};
        Nowhere nowhere;
        Islands::Tally tally;
        const EmissionPoints points(pass);
        const SplittingCounts counts =
            Splitting(space, points, pass, result.plan, result.guided).run(nowhere, tally);
        ASSERT_EQ(counts.levels.size(), result.plan.levels.size() + 1) << space.name;
        const bool is_alone = result.plan.levels.size() == 1 && result.guided.paths == 0;
        alone += is_alone ? 1 : 0;
        for (std::size_t k = 1; k < counts.levels.size(); ++k) {
            const bool is_rest = result.guided.paths > 0 && k + 1 == counts.levels.size();
            for (const Acceptance& kind : counts.levels[k].acceptances)
                EXPECT_NEAR(static_cast<double>(kind.accepted) / static_cast<double>(kind.proposed),
                            is_alone ? kTargetOfOneSet : kTargetAcceptance, is_rest ? 0.25 : 0.07)
                    << space.name << " level " << k;
        }
    }
    EXPECT_GT(alone, 0);
}

TEST(Pilot, plans_the_levels_that_the_rules_ask_for) {
    EXPECT_EQ(learn(spaces()[0], 1).plan.levels.size(), 1U);
    const PilotResult rare = learn(spaces()[3], 1);
    EXPECT_EQ(rare.plan.levels.size(), splitting_plan(rare.tail, kPaths).levels.size());
    EXPECT_GE(rare.plan.levels.size(), 4U);
    EXPECT_EQ(rare.last.levels.size(), rare.plan.levels.size() + 1);
    const Islands wide{"wide", {0}, {{0.5, 0.2, 0.5, 1}}, 1};
    EXPECT_EQ(learn(wide, 1).plan, (SplittingPlan{kPaths, {}}));
}

TEST(Pilot, plans_the_same_for_any_number_of_threads) {
    for (const Islands& space : {spaces()[1], spaces()[3]}) {
        const PilotResult first = learn(space, 1);
        for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
            const ThreadLimit limit(threads);
            const PilotResult again = learn(space, 1);
            EXPECT_EQ(again.plan, first.plan) << space.name << threads;
            EXPECT_EQ(again.tail, first.tail) << space.name << threads;
            EXPECT_EQ(again.paths, first.paths);
        }
    }
}

TEST(Pilot, other_seeds_and_epochs_draw_other_numbers) {
    const Islands space = spaces()[3];
    const HeightTail tail = learn(space, 1).tail;
    EXPECT_NE(learn(space, 2).tail, tail);
    const PilotResult later = Pilot<Islands, EmissionPoints>(space, {1, 1}).run(kPaths);
    EXPECT_NE(later.tail, tail);
}

TEST(Pilot, ends_where_nothing_is_visible) {
    Dark dark;
    dark.dimensions = {0, 6};
    dark.islands = {{0.3, 0.001, 0.5, 1}};
    const PilotResult result = Pilot<Dark, EmissionPoints>(dark, {1, 0}).run(kPaths);
    EXPECT_EQ(result.tail[kVisible], 0);
    ASSERT_FALSE(result.plan.levels.empty());
    EXPECT_LT(result.paths, 2'000'000U);
    const PassId pass{1, 0};
    Nowhere nowhere;
    Islands::Tally tally;
    const EmissionPoints points(pass);
    const SplittingCounts counts =
        Splitting(dark, points, pass, result.plan, {}).run(nowhere, tally);
    EXPECT_EQ(counts.visible_fraction, 0);
    const Islands nowhere_near{"empty", {0}, {}, 1};
    const PilotResult none = learn(nowhere_near, 1);
    EXPECT_EQ(none.plan.levels.size(), 1U);
    EXPECT_EQ(none.tail[kVisible], 0);
}

/// Islands that nothing leads to: elsewhere all paths are of height zero.
struct Hidden : Islands {
    int height(const Path& path) const { return path.height == kVisible ? kVisible : 0; }
};

Hidden hidden() {
    Hidden space;
    space.dimensions = {0, 6, 1, 2, 3, 4};
    space.islands = {{0.3, 1e-6, 0.5, 1}, {0.7, 5e-7, 0.5, 1}};
    space.narrow = 1;
    return space;
}

/// Emission on both islands, as walks from the other end would find it.
WalkedEmission guide_samples_of_hidden(PassId pass, const PathRange& walks) {
    WalkedEmission found;
    for (std::size_t i = walks.begin; i < walks.end; i += 2000) {
        RandomStream stream = pass.stream(Purpose::test, i);
        const bool first = stream.next() < 0.67;
        const double half = first ? 1e-6 : 5e-7;
        WeightedEmission& guide_sample = found.guide_samples.emplace_back();
        for (double& x : guide_sample.point) x = stream.next();
        guide_sample.point[0] = (first ? 0.3 : 0.7) + (2 * stream.next() - 1) * half;
    }
    return found;
}

// Two islands of 2.4e-6 in all: among 20,000 uniform paths none is found, and no height leads
// there.
TEST(Pilot, starts_from_guide_samples_where_climbing_fails) {
    const Hidden space = hidden();
    const PilotName name{1, 0};
    const PilotResult lost = Pilot<Hidden, EmissionPoints>(space, name).run(kPaths);
    EXPECT_EQ(lost.tail[kVisible], 0);
    EXPECT_EQ(lost.guided.paths, 0U);
    const PilotResult found =
        Pilot<Hidden, EmissionPoints>(space, name, {true, guide_samples_of_hidden}).run(kPaths);
    EXPECT_NEAR(found.tail[kVisible] / space.visible_fraction(), 1, 0.1);
    EXPECT_GT(found.guided.paths, kPaths / 2);
    EXPECT_EQ(found.guided.paths + found.plan.paths(), kPaths);
    for (const double centre : {0.3, 0.7})
        EXPECT_GT(found.guided.map.density({centre, 0.5, 0.5, 0.5, 0.5}), 1e4) << centre;
    const PilotResult off =
        Pilot<Hidden, EmissionPoints>(space, name, {false, guide_samples_of_hidden}).run(kPaths);
    EXPECT_EQ(off.guided.paths, 0U);
}

// Two islands of 1.2e-4 in all: of 20,000 uniform paths two or three are visible, often on one
// island alone. Climbing from these is luck.
TEST(Pilot, asks_for_guide_samples_where_climbing_was_luck) {
    Hidden space = hidden();
    space.islands = {{0.3, 4e-5, 0.5, 1}, {0.7, 2e-5, 0.5, 1}};
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const PilotResult found =
            Pilot<Hidden, EmissionPoints>(space, {seed, 0}, {true, guide_samples_of_hidden})
                .run(kPaths);
        EXPECT_NEAR(found.tail[kVisible] / space.visible_fraction(), 1, 0.2) << seed;
        for (const double centre : {0.3, 0.7})
            EXPECT_GT(found.guided.map.density({centre, 0.5, 0.5, 0.5, 0.5}), 1e3) << seed;
    }
}

// One light sample in a million arrives. It is looked for where it would be all that is seen, and
// where it would be a thousandth of that soon no more.
TEST(Pilot, looks_for_guide_samples_while_they_may_matter) {
    const Hidden space = hidden();
    for (const bool matters : {true, false}) {
        std::size_t walked = 0;
        const GuideSource blocked{true,
                                  [&](PassId, const PathRange& walks) {
                                      walked = walks.end;
                                      return WalkedEmission{{}, double(walks.end - walks.begin)};
                                  },
                                  {},
                                  [&](PassId) { return matters ? 1e-6 : 1e-3; }};
        Pilot<Hidden, EmissionPoints>(space, {1, 0}, blocked).run(kPaths);
        EXPECT_EQ(walked, matters ? 8'000'000U : 400'000U);
    }
}

// A picture of little work is not worth a search that takes longer than it does.
TEST(Pilot, looks_for_guide_samples_no_longer_than_the_picture_is_worth) {
    const Hidden space = hidden();
    for (const std::size_t worth : {1'000UL, 850'000UL, 100'000'000UL}) {
        std::size_t walked = 0;
        const GuideSource sealed{true,
                                 [&](PassId, const PathRange& walks) {
                                     walked = walks.end;
                                     return WalkedEmission{{}, double(walks.end - walks.begin)};
                                 },
                                 {},
                                 {},
                                 worth};
        Pilot<Hidden, EmissionPoints>(space, {1, 0}, sealed).run(kPaths);
        EXPECT_EQ(walked, std::clamp<std::size_t>(worth / 100'000 * 100'000, 500'000, 8'000'000));
    }
}

// Walks find nothing; one point in a hundred by an edge is on an island. Then there are no walks
// but the first ones, and where light would be seen in spots alone a tenth of the points.
TEST(Pilot, starts_from_points_by_edges_where_walks_find_nothing) {
    const Hidden space = hidden();
    for (const bool matters : {true, false}) {
        std::size_t walked = 0;
        std::size_t tried = 0;
        const GuideSource by_edges{
            true,
            [&](PassId, const PathRange& walks) {
                walked = walks.end;
                return WalkedEmission{{}, double(walks.end - walks.begin)};
            },
            [&](PassId pass, const PathRange& tries) {
                tried = tries.end;
                std::vector<WeightedEmission> all =
                    guide_samples_of_hidden(pass, {0, tries.end * 20}).guide_samples;
                all.resize(tries.end, {{0.1, 0.5, 0.5, 0.5, 0.5}, 1});
                return all;
            },
            [&](PassId) { return matters ? 1e-6 : 1e-3; }};
        const PilotResult found =
            Pilot<Hidden, EmissionPoints>(space, {1, 0}, by_edges).run(kPaths);
        EXPECT_EQ(walked, matters ? 500'000U : 400'000U);
        EXPECT_EQ(tried, matters ? 200'000U : 20'000U);
        EXPECT_NEAR(found.tail[kVisible] / space.visible_fraction(), 1, 0.1);
        EXPECT_GT(found.guided.paths, kPaths / 2);
    }
}

// Where uniform paths are not seen often there is a guide, and it covers most of what is seen.
TEST(Pilot, maps_what_is_seldom_seen) {
    const Islands often{"often", {0, 1, 6, 2, 3, 4}, {{0.3, 0.15, 0.5, 1}, {0.7, 0.1, 0.5, 5}}};
    EXPECT_EQ(learn(often, 1).guided.paths, 0U);
    const Islands seldom{"8e-3", {0, 1, 6, 2, 3, 4}, {{0.3, 0.04, 0.5, 1}, {0.7, 0.03, 0.5, 5}}};
    const PilotResult of_seldom = learn(seldom, 1);
    EXPECT_EQ(splitting_plan(of_seldom.tail, kPaths).levels.size(), 1U);
    EXPECT_GT(of_seldom.guided.paths, kPaths / 20);
    const Islands space{"1e-5", {0, 1, 6, 2, 3, 4}, {{0.3, 1.5e-3, 0.5, 1}, {0.7, 0.8e-3, 0.5, 5}}};
    const PilotResult learned = learn(space, 1);
    EXPECT_GT(learned.guided.paths, kPaths / 20);
    EXPECT_EQ(learned.guided.paths + learned.plan.paths(), kPaths);
    EXPECT_GT(learned.guided.map.density({0.3, 0.3, 0.5, 0.5, 0.5}), 100);
    const PilotResult off = Pilot<Islands, EmissionPoints>(space, {1, 0}, {false, {}}).run(kPaths);
    EXPECT_EQ(off.guided.paths, 0U);
    EXPECT_EQ(off.plan.levels.size(), splitting_plan(off.tail, kPaths).levels.size());
}

}  // namespace
}  // namespace sunfleck::engine
