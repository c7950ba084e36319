// Several sets of photons for the same visible points: their differences are the noise of a set.
#include "planning/indirect_choice.h"

#include "camera_paths/trace_camera_paths.h"
#include "photon_samplers/splitting_sampler.h"
#include "planning/judged_blocks.h"
#include "planning/trial_iterations.h"
#include "planning/trial_work.h"
#include "planning/way_tuning.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Moments of the mean light of a pixel, by block.
class BlockMoments {
public:
    /// @param camera  of all images.
    explicit BlockMoments(const CameraPass& camera)
        : blocks_(judged_blocks(camera.window, camera.cells)),
          pixels_of_a_path_(pixels_of_a_path(camera.cells)),
          sums_(blocks_.count()),
          squares_(blocks_.count()) {}

    /// @param light  of the pixels.
    void add(const PassImage& light) {
        const std::vector<double> sums = block_sums(blocks_, luminance_of(light));
        for (std::size_t b = 0; b < sums.size(); ++b) {
            const double mean =
                sums[b] * pixels_of_a_path_ / static_cast<double>(blocks_.block(b).pixels());
            sums_[b] += mean;
            squares_[b] += mean * mean;
        }
        ++count_;
    }

    std::size_t count() const { return sums_.size(); }
    double mean(std::size_t block) const { return sums_[block] / count_; }

    /// Returns the variances of one image.
    std::vector<double> variances() const {
        std::vector<double> variances;
        for (std::size_t b = 0; b < sums_.size(); ++b)
            variances.push_back(std::max(0.0, squares_[b] - sums_[b] * mean(b)) / (count_ - 1));
        return variances;
    }

private:
    BlockGrid blocks_;
    double pixels_of_a_path_;
    std::vector<double> sums_;
    std::vector<double> squares_;
    double count_ = 0;
};

std::size_t more_camera_trials(const CameraPass& camera) {
    const double paths =
        static_cast<double>(camera.window.pixels()) / pixels_of_a_path(camera.cells);
    return static_cast<std::size_t>(
        std::clamp<double>(kCameraPaths / paths, 1, kWayCameraIterations.size()));
}

/// Noise as the objective judges it, as the mean over blocks.
struct JudgedNoise {
    double camera = 0;
    double photons = 0;
    double missing = 0;  // light that the other way found, and this one did not
};

JudgedNoise judged_noise(const WayTrials& one, const WayTrials& other, double mean,
                         Objective objective) {
    const auto blocks = static_cast<double>(one.light.size());
    JudgedNoise noise;
    for (std::size_t b = 0; b < one.light.size(); ++b) {
        const double light = std::max(one.light[b], other.light[b]);
        const double square = squared_scale(objective, light, mean);
        noise.camera += one.camera.variance[b] / square / blocks;
        noise.missing += (other.light[b] - one.light[b]) / std::sqrt(square) / blocks;
        if (one.passes > 0) noise.photons += one.photons.variance[b] / square / blocks;
    }
    return noise;
}

}  // namespace

WayTrials camera_trials(const CameraPass& camera, const CameraTrial& seen, const PilotName& name) {
    BlockMoments moments(camera);
    moments.add(seen.image);
    for (std::size_t trial = 0; trial < more_camera_trials(camera); ++trial) {
        CameraPass pass = camera;
        pass.id = name.iteration(kWayCameraIterations.at(trial));
        PassImage image(camera.window.pixels(), {});
        Statistics unused;
        trace_camera_paths(pass, image, unused);
        moments.add(image);
    }
    const double fewer = pixels_of_a_path(camera.cells);  // paths than in a pass
    WayTrials trials{{}, {moments.variances(), camera_work(seen.counts) * fewer}, {}};
    for (double& variance : trials.camera.variance) variance /= fewer;
    for (std::size_t b = 0; b < moments.count(); ++b) trials.light.push_back(moments.mean(b));
    return trials;
}

void add_photon_trials(const CameraPass& camera, const CameraTrial& seen,
                       const std::vector<LightStratum>& plan, const PilotName& name,
                       WayTrials& trials) {
    const std::uint64_t paths = paths_of(plan);
    const std::vector<LightStratum> strata =
        fraction_of(plan, static_cast<std::uint32_t>(std::max(kLeastParts, paths / kPathsOfASet)));
    const double part = static_cast<double>(paths_of(strata)) / static_cast<double>(paths);
    const PhotonContext context{camera.scene, camera.transport, seen.index};
    BlockMoments moments(camera);
    Statistics counts;
    for (std::uint32_t set = 0; set < kWaySets; ++set) {
        PassImage image(camera.window.pixels(), {});
        const PhotonPass pass{context, name.iteration(kWaySetsIteration + set), strata, {}};
        NoState none;
        counts += SplittingSampler::trace(pass, {image}, none).statistics;
        moments.add(image);
    }
    trials.passes = kWaySets * part;
    trials.photons = {moments.variances(), photon_work(counts) / trials.passes};
    for (double& variance : trials.photons.variance) variance *= part;
    for (std::size_t b = 0; b < moments.count(); ++b) trials.light[b] += moments.mean(b);
}

double error_of_way(const WayTrials& one, const WayTrials& other, Objective objective) {
    const double mean = std::max(mean_value(one.light), mean_value(other.light));
    if (!(mean > 0)) return 0;
    const JudgedNoise noise = judged_noise(one, other, mean, objective);
    const double missing = std::max(0.0, noise.missing);
    const double found =
        std::sqrt(noise.camera * one.camera.work) + std::sqrt(noise.photons * one.photons.work);
    const double work = one.camera.work + one.photons.work;
    return found * found + one.passes * missing * missing * work;
}

}  // namespace sunfleck::engine
