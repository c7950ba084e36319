// Ways to share camera paths, the error that each would leave, and the least of these.
#include "planning/photon_budget.h"

#include "planning/trial_iterations.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck {
namespace {

constexpr double kSeeds = 128;  // of a ladder's one set in a draw, or more
constexpr double kRaysOfPath =
    0.6;  // work beside a camera path's rays: its point's place in the index
constexpr double kRaysOfDeposit = 0.6;  // work
constexpr double kMoreDeposits = 0.17;  // share of that, where a photon meets more points at once

constexpr double kWorthwhile = 0.96;  // of the error: for less there are no more camera paths

/// Of a draw, in rays.
struct Work {
    double eye = 0;       // with one camera path a pixel
    double photon = 0;    // of a photon path
    double deposits = 0;  // of a photon path, with one camera path a pixel

    DrawCost with(const CameraShares& shares, const PixelValues& taken) const {
        const double more = shares.doublings.empty() ? 0 : mean_paths(shares.doublings, taken) - 1;
        return {eye * shares.work, photon + deposits * (1 + kMoreDeposits * more)};
    }
};

Work work_of(const EyeView& view, const PhotonTrials& trials) {
    const auto count = [](const Statistics& counts, Count which) {
        return static_cast<double>(counts[which]);
    };
    const double paths = kPhotonSets * trials.pair.paths;
    return {
        count(view.counts, Count::eye_rays) + kRaysOfPath * count(view.counts, Count::camera_paths),
        count(trials.totals.statistics, Count::photon_rays) / paths,
        kRaysOfDeposit * trials.deposits / paths};
}

/// The share of the usual paths that leaves kSeeds.
/// @param found  seeds in all sets of photons. @param tried  the share that one of these has.
double share_of_seeds(std::uint64_t found, double tried) {
    return kSeeds * kPhotonSets * tried / static_cast<double>(found);
}

/// The share of the usual paths below which nothing is known of what paths are worth: that of the
/// trials, or less where a ladder has one set, seeds enough and no map beside it. All, where a
/// ladder has found nothing.
/// @param totals  of all sets of photons. @param tried  the share that one of them has.
double least_share(const std::vector<PhotonGroup>& groups, const PhotonTotals& totals,
                   double tried) {
    double share = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const PhotonGroup& group = groups[g];
        if (group.plan.levels.empty()) continue;
        const LadderCounts& ladder = totals.groups[g].ladder;
        if (!(ladder.visible_fraction > 0)) return 1;
        const bool is_simple = group.plan.levels.size() == 1 && group.mapped.paths == 0;
        const double for_seeds =
            is_simple ? share_of_seeds(ladder.survivors.front(), tried) : tried;
        share = std::max(share, std::min(for_seeds, tried));
    }
    return share;
}

/// What is foretold is not what comes to pass: twice the work must be worth 4% of the error.
double doubt(double work) {
    return std::sqrt(std::sqrt(std::sqrt(std::sqrt(work))));
}

/// The way of least error, each with its photon paths; the first, if that is hardly worse.
std::size_t best_of(const std::vector<DrawMeasures>& draws, const std::vector<Balance>& balances) {
    const auto work = [&](std::size_t way) {
        return draws[way].cost.eye + draws[way].cost.photon * balances[way].paths;
    };
    std::size_t best = 0;
    double least = kWorthwhile * error_of_draws(draws[0], balances[0].paths);
    for (std::size_t way = 1; way < draws.size(); ++way) {
        const double error =
            error_of_draws(draws[way], balances[way].paths) * doubt(work(way) / work(0));
        if (!(error < least)) continue;
        least = error;
        best = way;
    }
    return best;
}

}  // namespace

DrawPlan measured_plan(const EyePass& first, const EyeView& seen,
                       const std::vector<PhotonGroup>& plan, const PilotName& name,
                       const DrawWishes& wishes) {
    const PixelWindow& window = first.window;
    if (wishes.usual < 2 * wishes.parts) return {{wishes.usual}, {}};
    const bool shared = wishes.shares && may_be_shared(window);
    const PixelTrials pixels =
        shared ? trials_of_pixels(first, name, wishes.views) : no_trials(window);
    if (!(pixels.have_noise() || wishes.balance)) return {{wishes.usual}, {}};
    const std::vector<PhotonGroup> groups = part_of(plan, wishes.parts);
    EyePass second = first;
    second.id = name.round(kSecondViewRound);
    second.cells = wishes.cells;
    const PhotonTrials photons = photon_trials(second, seen, groups, name);
    const Work work = work_of(seen, photons);
    const double fewest = std::max(
        2.0, std::floor(least_share(groups, photons.totals, 1.0 / wishes.parts) * wishes.usual));
    std::vector<CameraShares> shares = camera_shares(window, pixels, photons.pair.one.lit[0]);
    shares.insert(shares.begin(), CameraShares{});  // one path each
    std::vector<DrawMeasures> draws;
    draws.reserve(shares.size());
    for (const CameraShares& way : shares)
        draws.push_back(
            {block_variances(window, photons.pair, pixels, way), work.with(way, photons.taken)});
    const std::vector<Balance> usual(draws.size(), {wishes.usual});
    const std::size_t at_usual = best_of(draws, usual);
    if (!wishes.balance) return {{wishes.usual}, std::move(shares[at_usual].doublings)};
    // Passes of the first epoch are of that kind.
    const double of_pass = error_of_draw(draws[at_usual], wishes.usual);
    std::vector<Balance> balances;
    balances.reserve(draws.size());
    for (const DrawMeasures& draw : draws)
        balances.push_back(balanced(draw, wishes.usual, fewest, of_pass));
    const std::size_t best = best_of(draws, balances);
    return {balances[best], std::move(shares[best].doublings)};
}

}  // namespace sunfleck
