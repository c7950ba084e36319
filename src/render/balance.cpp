// Two views, two sets of photons each, and what they cost.
#include "render/balance.h"

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
constexpr double kRaysOfPixel = 0.6;    // work beside its rays: its point's place in the index
constexpr double kRaysOfDeposit = 0.6;  // work
constexpr double kOfRound = 0.25;       // variance of a round's spread camera paths, over chance's

TrialPixels luminance_of(const PassImage& image) {
    TrialPixels pixels;
    pixels.reserve(image.pixels());
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const RgbSum sum{{image.value(Layer::total, i, 0), image.value(Layer::total, i, 1),
                          image.value(Layer::total, i, 2)}};
        pixels.push_back(sum.mean_luminance(1));
    }
    return pixels;
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

Balance measured_balance(const EyePass& first, const EyeView& seen,
                         const std::vector<PhotonGroup>& plan, const PilotName& name,
                         std::uint32_t usual) {
    if (usual < 2 * kSets) return {usual};
    const std::vector<PhotonGroup> groups = part_of(plan, kSets);
    Trials trials(first, groups, name);
    EyePass second = first;
    second.id = name.round(kRound);
    const TrialPair one = trials.of(seen, kRound + 1);
    const TrialPair other = trials.of(view_of(second), kRound + 3);
    const auto count = [](const Statistics& counts, Count which) {
        return static_cast<double>(counts[which]);
    };
    const auto paths = static_cast<double>(paths_of(groups));
    const auto pixels = static_cast<double>(first.window.pixels());
    const DrawCost cost{count(seen.counts, Count::eye_rays) + kRaysOfPixel * pixels,
                        (count(trials.counts(), Count::photon_rays) +
                         kRaysOfDeposit * count(trials.counts(), Count::deposits)) /
                            (kSets * paths)};
    const BlockGrid grid(first.window.width(), first.window.height(), kBlock);
    std::vector<BlockVariance> variances = block_variances(grid, one, other, paths);
    for (BlockVariance& block : variances) block.eye *= kOfRound;
    const double fewest = std::floor(trials.least_share() * usual);  // as balanced() rounds
    return balanced(variances, cost, usual, std::max(2.0, fewest));
}

}  // namespace sunfleck
