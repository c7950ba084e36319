// The visible points of both trials in one index, so that photons are gathered as in one pass.
#include "planning/photon_trials.h"

#include "camera_paths/trace_camera_paths.h"
#include "photon_samplers/splitting_sampler.h"
#include "planning/trial_iterations.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Returns an index of the first trial's points, and the second's with pixel numbers behind those.
VisiblePointIndex both(const CameraTrial& seen, VisiblePointLists others, std::size_t pixels,
                       int max_depth) {
    const std::span<const VisiblePoint> points = seen.index.points();
    for (auto& list : others)
        for (VisiblePoint& point : list) point.pixel += static_cast<std::uint32_t>(pixels);
    others.emplace_back(points.begin(), points.end());
    return {std::move(others), max_depth};
}

void add_light(const PassImage& image, std::size_t set, TrialPair& pair) {
    const PixelValues light = luminance_of(image);
    const std::size_t pixels = pair.one.camera.size();
    for (std::size_t i = 0; i < pixels; ++i) {
        pair.one.lit.at(set).push_back(pair.one.camera[i] + light[i]);
        pair.other.lit.at(set).push_back(pair.other.camera[i] + light[pixels + i]);
    }
}

}  // namespace

CameraTrial view_of(const CameraPass& pass) {
    PassImage image(pass.window.pixels(), {});
    Statistics counts;
    std::vector<Lit> lit(pass.direct_in_media ? pass.window.pixels() : 0, Lit::not_sampled);
    CameraPass noting = pass;
    noting.lit = lit;
    VisiblePointIndex index(trace_camera_paths(noting, image, counts), pass.transport.max_depth);
    return {std::move(image), counts, std::move(index), pass.cells, std::move(lit)};
}

std::vector<LightStratum> fraction_of(std::vector<LightStratum> strata, std::uint32_t parts) {
    const auto part = [&](std::uint32_t& number) {
        if (number > 0) number = std::max(1U, number / parts);
    };
    for (LightStratum& stratum : strata) {
        part(stratum.plan.uniform_paths);
        for (LevelPlan& level : stratum.plan.levels) {
            part(level.states);
            part(level.chains);
        }
        part(stratum.guided.paths);
    }
    return strata;
}

PhotonTrials photon_trials(const CameraPass& second, const CameraTrial& seen,
                           const std::vector<LightStratum>& strata, const PilotName& name) {
    const std::size_t pixels = second.window.pixels();
    PassImage unlit(pixels, {});
    Statistics unused;
    VisiblePointLists points = trace_camera_paths(second, unlit, unused);
    const VisiblePointIndex index =
        both(seen, std::move(points), pixels, second.transport.max_depth);
    PhotonTrials trials;
    trials.pair.one.camera = luminance_of(seen.image);
    trials.pair.other.camera = luminance_of(unlit);
    trials.pair.cells = second.cells;
    trials.pair.paths = static_cast<double>(paths_of(strata));
    PhotonCounts taken(2 * pixels);
    Statistics counts;
    const PhotonContext photon_context{second.scene, second.transport, index};
    for (std::uint32_t set = 0; set < kPhotonSets; ++set) {
        PassImage image(2 * pixels, {});
        const PhotonPass pass{
            photon_context, name.iteration(kPhotonSetsIteration + set), strata, {}};
        NoState none;
        counts += SplittingSampler::trace(pass, {image, &taken}, none).statistics;
        add_light(image, set, trials.pair);
    }
    const auto middle = taken.begin() + static_cast<std::ptrdiff_t>(pixels);
    trials.taken.assign(taken.begin(), middle);
    trials.photon_rays = counts[Count::photon_rays];
    const auto all = static_cast<double>(counts[Count::deposits]);
    const double here = std::accumulate(taken.begin(), middle, 0.0);
    const double there = std::accumulate(middle, taken.end(), 0.0);
    if (here > 0) trials.deposits = all * here / (here + there);
    return trials;
}

}  // namespace sunfleck::engine
