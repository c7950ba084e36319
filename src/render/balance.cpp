// Two views, two sets of photons each, and what they cost.
#include "render/balance.h"

#include "estimate/photon_counts.h"
#include "render/photon_stage.h"
#include "render/trial_rounds.h"
#include "render/trial_variance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck {
namespace {

constexpr std::size_t kBlock = 16;     // pixels a side: enough of them to tell a variance
constexpr std::uint64_t kSeeds = 128;  // of a ladder's one set, or more
constexpr double kRaysOfPath =
    0.6;  // work beside a camera path's rays: its point's place in the index
constexpr double kRaysOfDeposit = 0.6;  // work
constexpr double kMoreDeposits = 0.17;  // share of that, where a photon meets more points at once
constexpr double kOfRound = 0.25;       // variance of a round's spread camera paths, over chance's

constexpr double kWorthwhile = 0.96;  // of the error: for less there are no more camera paths

/// Of a draw, in rays.
struct Work {
    double eye = 0;       // with one camera path a pixel
    double photon = 0;    // of a photon path
    double deposits = 0;  // of a photon path, with one camera path a pixel
    TrialPixels taken;    // photons, by pixel

    DrawCost even() const { return {eye, photon + deposits}; }
    DrawCost with(const CameraShares& shares) const {
        const double more = times(shares.doublings, taken) - 1;
        return {eye * shares.work, photon + deposits * (1 + kMoreDeposits * more)};
    }
};

/// All that is measured of an epoch's draws.
struct Measured {
    std::vector<BlockVariance> blocks;  // with one camera path a pixel
    Work work;
    double fewest = 0;  // photon paths that a balance may take

    DrawMeasures even() const { return {blocks, work.even()}; }

    /// Light that photons bring may be noisy of camera paths, too, where trials of them alone see
    /// nothing: that noise stays.
    DrawMeasures with(const CameraShares& shares, const PixelTrials& trials,
                      const BlockGrid& grid) const {
        DrawMeasures draw{blocks, work.with(shares)};
        for (BlockVariance& block : draw.blocks) {
            const Foretold light = foretold(shares, trials, grid, block.block);
            if (!(light.even > 0) || !(block.eye > 0)) continue;
            const double spared =
                kOfRound * (light.even - light.left) / (block.brightness * block.brightness);
            block.eye = std::max(block.eye - spared, block.eye * light.left / light.even);
        }
        return draw;
    }
};

/// Ways to share camera paths, the first of them one a pixel, and the draws that each makes.
struct Ways {
    std::vector<Doublings> doublings;
    std::vector<DrawMeasures> draws;
};

Ways ways_of(const Measured& measured, std::vector<CameraShares> all, const PixelTrials& trials,
             const BlockGrid& grid) {
    Ways ways{{{}}, {measured.even()}};
    for (CameraShares& shares : all) {
        ways.draws.push_back(measured.with(shares, trials, grid));
        ways.doublings.push_back(std::move(shares.doublings));
    }
    return ways;
}

/// The way of least error with so many photon paths; the first, if that is hardly worse.
std::size_t best_way(const Ways& ways, std::uint32_t paths) {
    std::size_t best = 0;
    double least = kWorthwhile * error_of_draws(ways.draws[0], paths);
    for (std::size_t way = 1; way < ways.draws.size(); ++way) {
        const double error = error_of_draws(ways.draws[way], paths);
        if (!(error < least)) continue;
        least = error;
        best = way;
    }
    return best;
}

TrialPixels mean_of(const TrialPair& pair) {
    TrialPixels mean(pair[0].size());
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = (pair[0][i] + pair[1][i]) / 2;
    return mean;
}

TrialPair thinned(const TrialPair& pair, const PixelWindow& window, int every) {
    return {thinned(pair[0], window, every), thinned(pair[1], window, every)};
}

/// Sets of photons, and their counts together.
class Trials {
public:
    Trials(const EyePass& first, const std::vector<PhotonGroup>& groups, const PilotName& name)
        : first_(first), groups_(groups), name_(name), taken_(first.window.pixels()) {}

    /// A view's light, with two sets.
    TrialPair of(const EyeView& view) {
        const TrialPixels eye = luminance_of(view.image);
        TrialPixels one = pixels(view.index, eye);
        return {std::move(one), pixels(view.index, eye)};
    }

    /// Photon paths of a set.
    double paths() const { return static_cast<double>(paths_of(groups_)); }

    Work work(const EyeView& view) const {
        const auto count = [](const Statistics& counts, Count which) {
            return static_cast<double>(counts[which]);
        };
        return {count(view.counts, Count::eye_rays) +
                    kRaysOfPath * count(view.counts, Count::camera_paths),
                count(photons_.statistics, Count::photon_rays) / (sets_ * paths()),
                kRaysOfDeposit * count(photons_.statistics, Count::deposits) / (sets_ * paths()),
                TrialPixels(taken_.begin(), taken_.end())};
    }

    /// The share of the usual paths below which nothing is known of what paths are worth: that of
    /// the trials, or less where a ladder has one set and seeds enough. All, where a ladder has
    /// found nothing.
    /// @param tried  the trials' share.
    double least_share(double tried) const {
        double share = 0;
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const PhotonGroup& group = groups_[g];
            if (group.plan.levels.empty()) continue;
            const LadderCounts& ladder = photons_.groups[g].ladder;
            if (!(ladder.visible_fraction > 0)) return 1;
            const bool is_simple = group.plan.levels.size() == 1 && group.mapped.paths == 0;
            const double for_seeds =
                is_simple ? kSeeds / static_cast<double>(ladder.survivors.front()) : tried;
            share = std::max(share, std::min(for_seeds, tried));
        }
        return share;
    }

private:
    /// @param eye  light of the view that needs no photon.
    TrialPixels pixels(const VisiblePointIndex& index, const TrialPixels& eye) {
        PassImage image(first_.window.pixels(), {});
        photons_.add(trace_photons({first_.scene, first_.transport, index},
                                   name_.round(kPhotonSetsRound + sets_), PhotonSampler::adaptive,
                                   groups_, {image, &taken_}),
                     1);
        ++sets_;
        TrialPixels sum = luminance_of(image);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += eye[i];
        return sum;
    }

    const EyePass& first_;
    const std::vector<PhotonGroup>& groups_;
    PilotName name_;
    PhotonTotals photons_;  // of all sets
    PhotonCounts taken_;    // by them
    std::uint32_t sets_ = 0;
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
    const PixelWindow& window = first.window;
    const PixelTrials pixels = trials_of_pixels(first, name, wishes.views);
    if (usual < 2 * wishes.parts || !(pixels.have_noise() || wishes.balance)) return {{usual}, {}};
    const std::vector<PhotonGroup> groups = part_of(plan, wishes.parts);
    Trials trials(first, groups, name);
    EyePass second = first;
    second.id = name.round(kSecondViewRound);
    second.every = wishes.every;
    const TrialPair one = trials.of(seen);
    const Work work = trials.work(seen);
    const TrialPair other = trials.of(view_of(second));
    const BlockGrid tried(one_of(window.width(), wishes.every),
                          one_of(window.height(), wishes.every),
                          kBlock / static_cast<std::size_t>(wishes.every));
    Measured measured{block_variances(tried, thinned(one, window, wishes.every),
                                      thinned(other, window, wishes.every), trials.paths()),
                      work,
                      std::max(2.0, std::floor(trials.least_share(1.0 / wishes.parts) * usual))};
    for (BlockVariance& block : measured.blocks) block.eye *= kOfRound;
    const BlockGrid grid(window.width(), window.height(), kBlock);
    const Ways ways = ways_of(measured, camera_shares(window, pixels, mean_of(one)), pixels, grid);
    const std::size_t way = best_way(ways, usual);
    if (!wishes.balance) return {{usual}, ways.doublings[way]};
    return {balanced(ways.draws[way], usual, measured.fewest), ways.doublings[way]};
}

}  // namespace sunfleck
