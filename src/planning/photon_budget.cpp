// Allocations of camera paths, the error of each, and the best of them.
#include "planning/photon_budget.h"

#include "planning/trial_iterations.h"
#include "planning/trial_work.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck::engine {
namespace {

constexpr double kSurvivors = 128;  // at least so many per subpass, if splitting has one level set
constexpr double kMoreDeposits = 0.17;  // fraction of that for several points at once

constexpr double kWorthwhile = 0.96;  // of the error: worth more camera paths

/// Work of a subpass in rays.
struct Work {
    double camera = 0;    // with one camera path per pixel
    double photon = 0;    // of a photon path
    double deposits = 0;  // of a photon path, with one camera path per pixel

    SubpassCost with(const CameraShares& shares, const PixelValues& taken) const {
        const double more =
            shares.log2_samples.empty() ? 0 : mean_paths(shares.log2_samples, taken) - 1;
        return {camera * shares.work, photon + deposits * (1 + kMoreDeposits * more)};
    }
};

Work work_of(const CameraTrial& seen, const PhotonTrials& trials) {
    const auto rays = static_cast<double>(trials.totals.statistics[Count::photon_rays]);
    const double paths = kPhotonSets * trials.pair.paths;
    const double fewer = pixels_of_a_path(seen.cells);  // camera paths than in a subpass
    return {camera_work(seen.counts) * fewer, kWorkOfPhotonRay * rays / paths,
            kWorkOfDeposit * trials.deposits * fewer / paths};
}

/// Returns the fraction of the usual paths that leaves kSurvivors.
/// @param found  survivors in all sets of photons.
/// @param tried  fraction of the usual paths in each set.
double share_of_survivors(std::uint64_t found, double tried) {
    return kSurvivors * kPhotonSets * tried / static_cast<double>(found);
}

/// Returns the fraction of the usual paths below which measurements do not hold: that of the
/// trials, or less if splitting has one level set, enough survivors and no guide. One if splitting
/// found nothing.
/// @param totals  of all sets of photons.
/// @param tried  fraction of the usual paths in each set.
double least_share(const std::vector<LightStratum>& strata, const PhotonTotals& totals,
                   double tried) {
    double share = 0;
    for (std::size_t g = 0; g < strata.size(); ++g) {
        const LightStratum& stratum = strata[g];
        if (stratum.plan.levels.empty() || stratum.has_full_guide()) continue;
        const SplittingCounts& splitting = totals.strata[g].splitting;
        if (!(splitting.visible_fraction > 0)) return 1;
        const bool is_simple = stratum.plan.levels.size() == 1 && stratum.guided.paths == 0;
        const double for_survivors =
            is_simple ? share_of_survivors(splitting.survivors.front(), tried) : tried;
        share = std::max(share, std::min(for_survivors, tried));
    }
    return share;
}

/// Penalty for uncertain predictions: twice the work must reduce the error by 4%.
double doubt(double work) {
    return std::sqrt(std::sqrt(std::sqrt(std::sqrt(work))));
}

/// Returns the allocation of least error with its photon paths; the first unless another is clearly
/// better.
std::size_t best_of(const std::vector<SubpassMeasures>& subpasses,
                    const std::vector<PhotonBudget>& budgets) {
    const auto work = [&](std::size_t way) {
        return subpasses[way].cost.camera + subpasses[way].cost.photon * budgets[way].paths;
    };
    std::size_t best = 0;
    double least = kWorthwhile * error_of_subpasses(subpasses[0], budgets[0].paths);
    for (std::size_t way = 1; way < subpasses.size(); ++way) {
        const double error =
            error_of_subpasses(subpasses[way], budgets[way].paths) * doubt(work(way) / work(0));
        if (!(error < least)) continue;
        least = error;
        best = way;
    }
    return best;
}

}  // namespace

SubpassPlan measured_plan(const CameraPass& first, const CameraTrial& seen,
                          const std::vector<LightStratum>& plan, const PilotName& name,
                          const SubpassRequest& request) {
    const PixelWindow& window = first.window;
    if (request.usual < 2 * request.parts) return {{request.usual}, {}};
    const bool shared = request.shares && may_be_shared(window);
    const PixelTrials pixels =
        shared ? trials_of_pixels(first, name, request.trials) : no_trials(window);
    if (!(pixels.have_noise() || request.budget)) return {{request.usual}, {}};
    const std::vector<LightStratum> strata = fraction_of(plan, request.parts);
    CameraPass second = first;
    second.id = name.iteration(kSecondTrialIteration);
    second.cells = request.cells;
    const PhotonTrials photons = photon_trials(second, seen, strata, name);
    const Work work = work_of(seen, photons);
    const double fewest = std::max(
        2.0, std::floor(least_share(strata, photons.totals, 1.0 / request.parts) * request.usual));
    PixelValues light = photons.pair.one.lit[0];
    if (seen.cells > 1) light = upsampled(light, {window, seen.cells});
    std::vector<CameraShares> shares = camera_shares(window, pixels, light, request.objective);
    shares.insert(shares.begin(), CameraShares{});  // one path per pixel
    std::vector<SubpassMeasures> subpasses;
    subpasses.reserve(shares.size());
    for (const CameraShares& way : shares)
        subpasses.push_back({block_variances(window, photons.pair, pixels, way, request.objective),
                             work.with(way, photons.taken)});
    const std::vector<PhotonBudget> usual(subpasses.size(), {request.usual});
    const std::size_t at_usual = best_of(subpasses, usual);
    if (!request.budget) return {{request.usual}, std::move(shares[at_usual].log2_samples)};
    // Passes of the first epoch are usual ones.
    const double of_pass = error_of_subpass(subpasses[at_usual], request.usual);
    std::vector<PhotonBudget> budgets;
    budgets.reserve(subpasses.size());
    for (const SubpassMeasures& subpass : subpasses)
        budgets.push_back(allocated_budget(subpass, request.usual, fewest, of_pass));
    const std::size_t best = best_of(subpasses, budgets);
    return {budgets[best], std::move(shares[best].log2_samples)};
}

}  // namespace sunfleck::engine
