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
#include <utility>

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

    /// @param work  of a pass. @param part  of a pass's paths has one image.
    Brought brought(double work, double part) const {
        Brought all{.light = {}, .variance = {}, .work = work, .passes = count_ * part};
        for (std::size_t b = 0; b < sums_.size(); ++b) {
            const double mean = sums_[b] / count_;
            all.light.push_back(mean);
            all.variance.push_back(std::max(0.0, squares_[b] - sums_[b] * mean) / (count_ - 1) *
                                   part);
        }
        return all;
    }

private:
    BlockGrid blocks_;
    double pixels_of_a_path_;
    std::vector<double> sums_;
    std::vector<double> squares_;
    double count_ = 0;
};

/// Returns the mean of both.
Brought mixed(Brought one, const Brought& other) {
    one.passes += other.passes;
    const double share = other.passes / one.passes;
    const auto mix = [share](double& a, double b) { a += share * (b - a); };
    for (std::size_t b = 0; b < one.light.size(); ++b) {
        mix(one.light[b], other.light[b]);
        mix(one.variance[b], other.variance[b]);
    }
    mix(one.work, other.work);
    return one;
}

std::size_t more_camera_trials(const CameraPass& camera) {
    const double paths =
        static_cast<double>(camera.window.pixels()) / pixels_of_a_path(camera.cells);
    return static_cast<std::size_t>(
        std::clamp<double>(kCameraPaths / paths, 1, kWayCameraIterations.size()));
}

double mean_light(const WayTrials& way) {
    return mean_value(way.camera.light) + (way.sets > 0 ? mean_value(way.photons.light) : 0);
}

/// Noise as the objective judges it, as the mean over blocks.
struct JudgedNoise {
    double camera = 0;
    double photons = 0;
    double missing = 0;  // squared light that the other way found, and this one did not
};

JudgedNoise judged_noise(const WayTrials& one, const WayTrials& other, double mean,
                         Objective objective) {
    const auto blocks = static_cast<double>(one.blocks());
    JudgedNoise noise;
    for (std::size_t b = 0; b < one.blocks(); ++b) {
        const double square =
            squared_scale(objective, std::max(one.light(b), other.light(b)), mean);
        noise.camera += one.camera.variance[b] / square / blocks;
        const double more = other.light(b) - one.light(b);
        const double by_chance = one.variance(b) + other.variance(b);
        const double missing = std::max(0.0, more * more - by_chance) / square / blocks;
        noise.missing += more > 0 ? missing : -missing;
        if (one.sets > 0) noise.photons += one.photons.variance[b] / square / blocks;
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
    return {.camera = moments.brought(camera_work(seen.counts) * fewer, 1 / fewer),
            .photons = {},
            .goes_beyond = camera.transport.goes_beyond_diffuse()};
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
        const PhotonPass pass{
            context, name.iteration(kWaySetsIteration + trials.sets + set), strata, {}};
        NoState none;
        counts += SplittingSampler::trace(pass, {image}, none).statistics;
        moments.add(image);
    }
    Brought more = moments.brought(photon_work(counts) / (kWaySets * part), part);
    trials.photons = trials.sets == 0 ? std::move(more) : mixed(std::move(trials.photons), more);
    trials.sets += kWaySets;
}

double error_of_way(const WayTrials& one, const WayTrials& other, Objective objective) {
    const double mean = std::max(mean_light(one), mean_light(other));
    if (!(mean > 0)) return 0;
    const JudgedNoise noise = judged_noise(one, other, mean, objective);
    const double missing = std::max(0.0, noise.missing);
    const double found =
        std::sqrt(noise.camera * one.camera.work) + std::sqrt(noise.photons * one.photons.work);
    const double work = one.camera.work + one.photons.work;
    return found * found + one.passes() * missing * work;
}

}  // namespace sunfleck::engine
