// Allocations of camera paths, the error of each, and the best of them.
#include "planning/pixel_allocation.h"

#include "planning/pixel_tuning.h"
#include "planning/trial_iterations.h"
#include "planning/trial_work.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Returns the number of visible points of each pixel of a trial.
PixelValues points_of(const CameraTrial& seen, std::size_t pixels) {
    PixelValues points(pixels, 0);
    for (const VisiblePoint& point : seen.index.points()) ++points[point.pixel];
    return points;
}

/// Work of a pass in rays, by what more camera paths add to it.
struct Work {
    double camera = 0;    // with one camera path per pixel
    double photons = 0;   // of all photon paths
    double deposits = 0;  // of all photon paths, with one camera path per pixel
    double points = 0;    // with one camera path per pixel
    PixelValues taken;    // photons of each pixel of a trial
    PixelValues points_of_pixels;

    double with(const CameraShares& shares) const {
        const Log2Samples& paths = shares.log2_samples;
        if (paths.empty()) return camera + photons + deposits + points;
        return camera * shares.work + photons + deposits * mean_paths(paths, taken) +
               points * mean_paths(paths, points_of_pixels);
    }
};

/// @param paths  photon paths of a pass.
Work work_of(const CameraTrial& seen, const PhotonTrials& trials, double paths) {
    const double passes = kPhotonSets * trials.pair.paths / paths;  // that photons of trials fill
    const auto rays = static_cast<double>(trials.photon_rays);
    const double fewer = pixels_of_a_path(seen.cells);  // camera paths than in a pass
    const auto points = static_cast<double>(seen.index.points().size());
    return {.camera = camera_work(seen.counts) * fewer,
            .photons = kWorkOfPhotonRay * rays / passes,
            .deposits = kWorkOfDeposit * trials.deposits * fewer / passes,
            .points = kWorkOfPoint * points * fewer,
            .taken = trials.taken,
            .points_of_pixels = points_of(seen, trials.taken.size())};
}

/// Penalty for uncertain predictions: twice the work must reduce the error by 4%.
double doubt(double work) {
    return std::sqrt(std::sqrt(std::sqrt(std::sqrt(work))));
}

/// The largest noise that camera paths of a batch may have.
constexpr VarianceDecay kIndependent{.doubling = 0.5};

/// Returns whether camera paths without noise would be worth an allocation.
bool may_pay(std::vector<BlockVariance> blocks, double paths) {
    const double usual = error_of_pass(blocks, paths, 1);
    for (BlockVariance& block : blocks) block.camera = 0;
    return error_of_pass(blocks, paths, 1) < kWorthwhile * usual;
}

}  // namespace

double error_of_pass(const std::vector<BlockVariance>& blocks, double paths, double work) {
    double sum = 0;
    for (const BlockVariance& block : blocks)
        sum += std::sqrt(std::max(0.0, block.camera) + std::max(0.0, block.photon) / paths);
    return sum * std::sqrt(work);
}

Log2Samples chosen_allocation(const CameraPass& first, const CameraTrial& seen,
                              const std::vector<LightStratum>& plan, const PilotName& name,
                              const AllocationRequest& request) {
    const PixelWindow& window = first.window;
    if (!may_be_shared(window)) return {};
    CameraPass second = first;
    second.id = name.iteration(kSecondTrialIteration);
    second.cells = request.cells;
    const PhotonTrials photons =
        photon_trials(second, seen, fraction_of(plan, request.parts), name);
    const auto paths = static_cast<double>(paths_of(plan));
    const auto variances = [&](const PixelTrials& pixels, const CameraShares& shares) {
        return block_variances(window, photons.pair, pixels, shares, request.objective);
    };
    if (!may_pay(variances(no_trials(window, kIndependent), {}), paths)) return {};
    const PixelTrials pixels = trials_of_pixels(first, name, request.pixels);
    if (!pixels.have_noise()) return {};
    const Work work = work_of(seen, photons, paths);
    const double usual_work = work.with({});
    double least = kWorthwhile * error_of_pass(variances(pixels, {}), paths, usual_work);
    PixelValues light = photons.pair.one.lit[0];
    if (seen.cells > 1) light = upsampled(light, {window, seen.cells});
    Log2Samples best;
    for (CameraShares& shares : camera_shares(window, pixels, light, request.objective)) {
        const double all_work = work.with(shares);
        const double error = error_of_pass(variances(pixels, shares), paths, all_work) *
                             doubt(all_work / usual_work);
        if (!(error < least)) continue;
        least = error;
        best = std::move(shares.log2_samples);
    }
    return best;
}

}  // namespace sunfleck::engine
