// Both views' points in one index: photons meet them as those of one pass.
#include "planning/photon_trials.h"

#include "camera_paths/trace_camera_paths.h"
#include "planning/trial_iterations.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace sunfleck {
namespace {

/// The first view's points, and the second's as pixels behind those of the first.
VisiblePointIndex both(const EyeView& seen, VisiblePointLists others, std::size_t pixels,
                       int max_depth) {
    const std::span<const VisiblePoint> points = seen.index.points();
    for (auto& list : others)
        for (VisiblePoint& point : list) point.pixel += static_cast<std::uint32_t>(pixels);
    others.emplace_back(points.begin(), points.end());
    return {std::move(others), max_depth};
}

void add_light(const PassImage& image, std::size_t set, TrialPair& pair) {
    const PixelValues light = luminance_of(image);
    const std::size_t pixels = pair.one.eye.size();
    for (std::size_t i = 0; i < pixels; ++i) {
        pair.one.lit.at(set).push_back(pair.one.eye[i] + light[i]);
        pair.other.lit.at(set).push_back(pair.other.eye[i] + light[pixels + i]);
    }
}

}  // namespace

EyeView view_of(const EyePass& pass) {
    PassImage image(pass.window.pixels(), {});
    Statistics counts;
    VisiblePointIndex index(trace_eye_paths(pass, image, counts), pass.transport.max_depth);
    return {std::move(image), counts, std::move(index)};
}

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

PhotonTrials photon_trials(const EyePass& second, const EyeView& seen,
                           const std::vector<PhotonGroup>& groups, const PilotName& name) {
    const std::size_t pixels = second.window.pixels();
    PassImage unlit(pixels, {});
    Statistics unused;
    VisiblePointLists points = trace_eye_paths(second, unlit, unused);
    const VisiblePointIndex index =
        both(seen, std::move(points), pixels, second.transport.max_depth);
    PhotonTrials trials;
    trials.pair.one.eye = luminance_of(seen.image);
    trials.pair.other.eye = luminance_of(unlit);
    trials.pair.cells = second.cells;
    trials.pair.paths = static_cast<double>(paths_of(groups));
    PhotonCounts taken(2 * pixels);
    for (std::uint32_t set = 0; set < kPhotonSets; ++set) {
        PassImage image(2 * pixels, {});
        trials.totals.add(trace_photons({second.scene, second.transport, index},
                                        name.round(kPhotonSetsRound + set), PhotonSampler::adaptive,
                                        groups, {image, &taken}),
                          1.0 / kPhotonSets);
        add_light(image, set, trials.pair);
    }
    const auto middle = taken.begin() + static_cast<std::ptrdiff_t>(pixels);
    trials.taken.assign(taken.begin(), middle);
    const auto all = static_cast<double>(trials.totals.statistics[Count::deposits]);
    const double here = std::accumulate(taken.begin(), middle, 0.0);
    const double there = std::accumulate(middle, taken.end(), 0.0);
    if (here > 0) trials.deposits = all * here / (here + there);
    return trials;
}

}  // namespace sunfleck
