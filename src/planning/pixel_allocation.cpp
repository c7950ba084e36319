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

/// Work of a pass in rays.
struct Work {
    double camera = 0;    // with one camera path per pixel
    double photons = 0;   // of all photon paths
    double deposits = 0;  // of all photon paths, with one camera path per pixel

    double with(const CameraShares& shares, const PixelValues& taken) const {
        const double more =
            shares.log2_samples.empty() ? 0 : mean_paths(shares.log2_samples, taken) - 1;
        return camera * shares.work + photons + deposits * (1 + kMoreDeposits * more);
    }
};

/// @param paths  photon paths of a pass.
Work work_of(const CameraTrial& seen, const PhotonTrials& trials, double paths) {
    const double passes = kPhotonSets * trials.pair.paths / paths;  // that photons of trials fill
    const auto rays = static_cast<double>(trials.photon_rays);
    const double fewer = pixels_of_a_path(seen.cells);  // camera paths than in a pass
    return {camera_work(seen.counts) * fewer, kWorkOfPhotonRay * rays / passes,
            kWorkOfDeposit * trials.deposits * fewer / passes};
}

/// Penalty for uncertain predictions: twice the work must reduce the error by 4%.
double doubt(double work) {
    return std::sqrt(std::sqrt(std::sqrt(std::sqrt(work))));
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
    const PixelTrials pixels = trials_of_pixels(first, name, request.pixels);
    if (!pixels.have_noise()) return {};
    CameraPass second = first;
    second.id = name.iteration(kSecondTrialIteration);
    second.cells = request.cells;
    const PhotonTrials photons =
        photon_trials(second, seen, fraction_of(plan, request.parts), name);
    const auto paths = static_cast<double>(paths_of(plan));
    const Work work = work_of(seen, photons, paths);
    const auto error_of = [&](const CameraShares& shares, double all_work) {
        return error_of_pass(
            block_variances(window, photons.pair, pixels, shares, request.objective), paths,
            all_work);
    };
    const double usual_work = work.with({}, photons.taken);
    double least = kWorthwhile * error_of({}, usual_work);
    PixelValues light = photons.pair.one.lit[0];
    if (seen.cells > 1) light = upsampled(light, {window, seen.cells});
    Log2Samples best;
    for (CameraShares& shares : camera_shares(window, pixels, light, request.objective)) {
        const double all_work = work.with(shares, photons.taken);
        const double error = error_of(shares, all_work) * doubt(all_work / usual_work);
        if (!(error < least)) continue;
        least = error;
        best = std::move(shares.log2_samples);
    }
    return best;
}

}  // namespace sunfleck::engine
