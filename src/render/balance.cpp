// Two views, two sets of photons each, and what they cost.
#include "render/balance.h"

#include "render/noisy_pixels.h"
#include "render/photon_stage.h"
#include "render/trial_variance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck {
namespace {

constexpr std::size_t kBlock = 16;      // pixels a side: enough of them to tell a variance
constexpr std::uint32_t kSets = 4;      // of photons, which together are those of one usual pass
constexpr double kTried = 1.0 / kSets;  // share of the usual paths that a trial has
constexpr std::uint32_t kRound = 500;   // of the pilots' numbers: beyond all that they use
constexpr std::uint64_t kSeeds = 128;   // of a ladder's one set, or more
constexpr double kRaysOfPath =
    0.6;  // work beside a camera path's rays: its point's place in the index
constexpr double kRaysOfDeposit = 0.6;  // work
constexpr double kOfRound = 0.25;       // variance of a round's spread camera paths, over chance's

constexpr double kWorthwhile = 0.95;  // of the error: for less there are no more camera paths

/// Of a draw, in rays.
struct Work {
    double eye = 0;       // with one camera path a pixel
    double photon = 0;    // of a photon path
    double deposits = 0;  // of a photon path, with one camera path a pixel

    /// @param shares  work of the camera paths over that of one a pixel.
    DrawCost cost(double shares) const { return {eye * shares, photon + deposits * shares}; }
};

/// @param paths  photon paths of a set.
Work work_of(const EyeView& seen, const Statistics& photons, double paths) {
    const auto count = [](const Statistics& counts, Count which) {
        return static_cast<double>(counts[which]);
    };
    return {
        count(seen.counts, Count::eye_rays) + kRaysOfPath * count(seen.counts, Count::camera_paths),
        count(photons, Count::photon_rays) / (kSets * paths),
        kRaysOfDeposit * count(photons, Count::deposits) / (kSets * paths)};
}

/// All that is measured of an epoch's draws.
struct Measured {
    std::vector<BlockVariance> blocks;  // with one camera path a pixel
    Work work;
    std::uint32_t usual = 0;  // photon paths
    double fewest = 0;        // that a balance may take
    bool may_balance = true;  // or paths are as usual

    DrawMeasures even() const { return {blocks, work.cost(1)}; }

    DrawMeasures with(const CameraShares& shares, const PixelTrials& trials,
                      const BlockGrid& grid) const {
        DrawMeasures draw{blocks, work.cost(shares.work)};
        for (BlockVariance& block : draw.blocks)
            block.eye *= left_of(shares, trials, grid, block.block);
        return draw;
    }

    Balance best_for(const DrawMeasures& draw, const DrawMeasures& even) const {
        if (!may_balance) return {usual};
        return balanced(draw, usual, fewest, &even);
    }
};

/// Camera paths shared in the best of these ways, each with the balance that is best for it; or one
/// a pixel, if that is hardly worse.
DrawPlan best_plan(const Measured& measured, std::vector<CameraShares> ways,
                   const PixelTrials& trials, const BlockGrid& grid) {
    const DrawMeasures even = measured.even();
    DrawPlan best{measured.best_for(even, even), {}};
    double least = kWorthwhile * error_of_render(even, measured.usual, even, best.balance);
    for (CameraShares& way : ways) {
        const DrawMeasures draw = measured.with(way, trials, grid);
        const Balance balance = measured.best_for(draw, even);
        const double error = error_of_render(even, measured.usual, draw, balance);
        if (!(error < least)) continue;
        least = error;
        best = {balance, std::move(way.doublings)};
    }
    return best;
}

TrialPixels mean_of(const TrialPair& one, const TrialPair& other) {
    TrialPixels mean(one[0].size());
    for (std::size_t i = 0; i < mean.size(); ++i)
        mean[i] = (one[0][i] + one[1][i] + other[0][i] + other[1][i]) / kSets;
    return mean;
}

/// Trial passes, and their photons' counts together.
class Trials {
public:
    Trials(const EyePass& first, const std::vector<PhotonGroup>& groups, const PilotName& name)
        : first_(first), groups_(groups), name_(name) {}

    /// @param round  of the first of two.
    TrialPair of(const EyeView& view, std::uint32_t round) {
        const TrialPixels eye = luminance_of(view.image);
        return {pixels(view.index, eye, round), pixels(view.index, eye, round + 1)};
    }

    const Statistics& counts() const { return photons_.statistics; }

    /// The share of the usual paths below which nothing is known of what paths are worth: that of
    /// the trials, or less where a ladder has one set and seeds enough. All, where a ladder has
    /// found nothing.
    double least_share() const {
        double share = 0;
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const PhotonGroup& group = groups_[g];
            if (group.plan.levels.empty()) continue;
            const LadderCounts& ladder = photons_.groups[g].ladder;
            if (!(ladder.visible_fraction > 0)) return 1;
            const bool is_simple = group.plan.levels.size() == 1 && group.mapped.paths == 0;
            const double for_seeds =
                is_simple ? kSeeds / static_cast<double>(ladder.survivors.front()) : kTried;
            share = std::max(share, std::min(for_seeds, kTried));
        }
        return share;
    }

private:
    /// @param eye  light of the view that needs no photon.
    TrialPixels pixels(const VisiblePointIndex& index, const TrialPixels& eye,
                       std::uint32_t round) {
        PassImage image(first_.window.pixels(), {});
        photons_.add(trace_photons({first_.scene, first_.transport, index}, name_.round(round),
                                   PhotonSampler::adaptive, groups_, {image}),
                     kTried);
        TrialPixels sum = luminance_of(image);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += eye[i];
        return sum;
    }

    const EyePass& first_;
    const std::vector<PhotonGroup>& groups_;
    PilotName name_;
    PhotonTotals photons_;  // of all trials
};

}  // namespace

std::vector<PhotonGroup> part_of(std::vector<PhotonGroup> groups, std::uint32_t parts) {
    const auto part = [&](std::uint32_t& number) { number = std::max(1U, number / parts); };
    for (PhotonGroup& group : groups) {
        part(group.plan.uniform_paths);
        for (LevelPlan& level : group.plan.levels) {
            part(level.states);
            part(level.chains);
        }
        if (group.mapped.paths > 0) part(group.mapped.paths);
    }
    return groups;
}

EyeView view_of(const EyePass& pass) {
    PassImage image(pass.window.pixels(), {});
    Statistics counts;
    VisiblePointIndex index(trace_eye_paths(pass, image, counts), pass.transport.max_depth);
    return {std::move(image), counts, std::move(index)};
}

DrawPlan measured_plan(const EyePass& first, const EyeView& seen,
                       const std::vector<PhotonGroup>& plan, const PilotName& name,
                       const DrawWishes& wishes) {
    const std::uint32_t usual = wishes.usual;
    const PixelTrials pixels = wishes.shares ? trials_of_pixels(first, name) : PixelTrials();
    const bool shares = pixels.have_noise();
    if (usual < 2 * kSets || !(shares || wishes.balance)) return {{usual}, {}};
    const std::vector<PhotonGroup> groups = part_of(plan, kSets);
    Trials trials(first, groups, name);
    EyePass second = first;
    second.id = name.round(kRound);
    const TrialPair one = trials.of(seen, kRound + 1);
    const TrialPair other = trials.of(view_of(second), kRound + 3);
    const BlockGrid grid(first.window.width(), first.window.height(), kBlock);
    const auto paths = static_cast<double>(paths_of(groups));
    const double fewest = std::floor(trials.least_share() * usual);  // as balanced() rounds
    Measured measured{block_variances(grid, one, other, paths),
                      work_of(seen, trials.counts(), paths), usual, std::max(2.0, fewest),
                      wishes.balance};
    for (BlockVariance& block : measured.blocks) block.eye *= kOfRound;
    std::vector<CameraShares> ways;
    if (shares) ways = camera_shares(first.window, pixels, mean_of(one, other));
    return best_plan(measured, std::move(ways), pixels, grid);
}

}  // namespace sunfleck
