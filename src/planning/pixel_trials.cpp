// Trials by nets of four, and their variance within and between nets.
#include "planning/pixel_trials.h"

#include "camera_paths/trace_camera_paths.h"
#include "film/luminance.h"
#include "planning/trial_iterations.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck::engine {
namespace {

constexpr std::uint32_t kNet = 4;  // trials per net

/// Means over nets.
struct Spread {
    std::array<PixelValues, 2> within;  // by half: variance around the mean of a net's paths
    PixelValues between;                // variance of the means of nets

    explicit Spread(std::size_t pixels)
        : within{PixelValues(pixels, 0), PixelValues(pixels, 0)}, between(pixels, 0) {}
};

/// Adds the variance of a net, weighted. @param first  of its passes; they count the rays.
/// @return the mean of the net.
PixelValues add_net(const CameraPass& first, double share, PixelValues& within) {
    CameraPass pass = first;
    const std::size_t pixels = within.size();
    PixelValues sum(pixels, 0);
    PixelValues squares(pixels, 0);
    for (std::uint32_t trial = 0; trial < kNet; ++trial) {
        pass.id.number = first.id.number + trial;
        PassImage image(pixels, {});
        Statistics unused;
        trace_camera_paths(pass, image, unused);
        const PixelValues light = luminance_of(image);
        for (std::size_t i = 0; i < pixels; ++i) {
            sum[i] += light[i];
            squares[i] += light[i] * light[i];
        }
    }
    for (std::size_t i = 0; i < pixels; ++i) {
        within[i] += share * std::max(0.0, squares[i] - sum[i] * sum[i] / kNet) / (kNet - 1);
        sum[i] /= kNet;
    }
    return sum;
}

/// @param pass  counts the rays.
Spread spread_of(CameraPass pass, const PilotName& name, std::uint32_t pairs) {
    Spread spread(pass.window.pixels());
    const PassId batch = name.iteration(kPixelTrialsIteration);
    const double share = 1.0 / pairs;
    for (std::uint32_t pair = 0; pair < pairs; ++pair) {
        pass.id = batch.replicate(2 * pair);
        const PixelValues one = add_net(pass, share, spread.within[0]);
        pass.id = batch.replicate(2 * pair + 1);
        const PixelValues other = add_net(pass, share, spread.within[1]);
        for (std::size_t i = 0; i < one.size(); ++i)
            spread.between[i] += share * (one[i] - other[i]) * (one[i] - other[i]) / 2;
    }
    return spread;
}

/// Returns the variance of a net over that of as many independent paths.
/// @param within  of a net's paths.
/// @param between  of the means of nets.
double net_over_chance(double within, double between) {
    const double path = (kNet - 1.0) / kNet * within + between;
    return std::clamp(kNet * between / path, 1.0 / 16, 1.0);
}

double sum_of(const PixelValues& pixels, const BlockGrid& grid, std::size_t block) {
    double sum = 0;
    grid.for_pixels(block, [&](std::size_t i) { sum += pixels[i]; });
    return sum;
}

/// Returns the variance decay of each block, and converts its noise to that of independent paths.
std::vector<VarianceDecay> laws_of(Spread& spread, const PixelWindow& window) {
    const BlockGrid grid(window.width(), window.height(), kTrialBlock);
    std::vector<VarianceDecay> laws(grid.count());
    for (std::size_t block = 0; block < laws.size(); ++block) {
        const double within =
            (sum_of(spread.within[0], grid, block) + sum_of(spread.within[1], grid, block)) / 2;
        if (!(within > 0)) continue;
        const double over = net_over_chance(within, sum_of(spread.between, grid, block));
        laws[block].doubling = std::sqrt(std::sqrt(over)) / 2;
        const double scale = (1 - 1.0 / kNet) / (1 - over / kNet);
        for (PixelValues& half : spread.within)
            grid.for_pixels(block, [&](std::size_t i) { half[i] *= scale; });
    }
    return laws;
}

}  // namespace

double VarianceDecay::left(unsigned log2_samples) const {
    double left = 1;
    for (unsigned i = 0; i < log2_samples; ++i) left *= doubling;
    return left;
}

double VarianceDecay::of_batch() const {
    const double over = 2 * doubling;
    return over * over * over * over * over * over;
}

bool PixelTrials::have_noise() const {
    const auto any = [](const PixelValues& half) {
        return std::any_of(half.begin(), half.end(), [](double v) { return v > 0; });
    };
    return any(variance[0]) && any(variance[1]);
}

PixelTrials no_trials(const PixelWindow& window, const VarianceDecay& net) {
    const BlockGrid grid(window.width(), window.height(), kTrialBlock);
    return {{}, {}, std::vector(grid.count(), net)};
}

PixelTrials trials_of_pixels(const CameraPass& first, const PilotName& name,
                             const TrialEffort& effort) {
    const PixelWindow& window = first.window;
    std::vector<std::uint64_t> counts(window.pixels(), 0);
    CameraPass pass = first;
    pass.rays = counts;
    pass.cells = effort.cells;
    Spread spread = spread_of(pass, name, effort.pairs_of_nets);
    const auto of_all = [&](const PixelValues& pixels) {
        return upsampled(pixels, {window, effort.cells});
    };
    for (PixelValues& half : spread.within) half = of_all(half);
    spread.between = of_all(spread.between);
    PixelValues rays;
    rays.reserve(counts.size());
    for (const std::uint64_t n : counts)
        rays.push_back(static_cast<double>(n) / (2 * kNet * effort.pairs_of_nets));
    std::vector<VarianceDecay> nets = laws_of(spread, window);
    return {std::move(spread.within), of_all(rays), std::move(nets)};
}

}  // namespace sunfleck::engine
