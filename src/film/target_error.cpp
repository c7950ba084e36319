// Quantiles and means over bright blocks.
#include "film/target_error.h"

#include "film/bias.h"
#include "math/wavelengths.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sunfleck::engine {
namespace {

struct BrightBlock {
    std::size_t number;
    MeanError luminance;
};

std::vector<BrightBlock> bright_blocks(const Film& film) {
    std::vector<BrightBlock> bright;
    const auto image = image_error(film);
    if (!image) return bright;
    const double floor = 0.01 * image->mean;
    const std::vector<MeanError> blocks = block_errors(film);
    for (std::size_t b = 0; b < blocks.size(); ++b)
        if (floor > 0 && blocks[b].mean > floor) bright.push_back({b, blocks[b]});
    return bright;
}

/// @param bright  at least one.
double noise_of(const Film& film, const std::vector<BrightBlock>& bright, bool extrapolated) {
    const auto errors = extrapolated ? extrapolated_block_errors(film) : std::vector<double>();
    std::vector<double> relative;
    for (const BrightBlock& block : bright) {
        const double error = errors.empty() ? block.luminance.standard_error : errors[block.number];
        relative.push_back(error / block.luminance.mean);
    }
    std::sort(relative.begin(), relative.end());
    const double wider = errors.empty() ? widening(film) : line_widening(film);
    return wider * relative[(relative.size() * 95 + 99) / 100 - 1];
}

/// @param bright  at least one. Nothing where no bias is known.
std::optional<double> bias_of(const Film& film, const std::vector<BrightBlock>& bright) {
    const std::vector<Bias> biases = block_biases(film);
    if (biases.empty()) return {};
    double sum = 0;
    for (const BrightBlock& block : bright) {
        const Bias& bias = biases[block.number];
        const double square = bias.value * bias.value - bias.standard_error * bias.standard_error;
        sum += square / (block.luminance.mean * block.luminance.mean);
    }
    return std::sqrt(std::max(0.0, sum / static_cast<double>(bright.size())));
}

}  // namespace

double times_passes_to(const TargetError& error, double target, double alpha) {
    double low = 1;
    double high = 0x1p50;
    for (int i = 0; i < 50; ++i) {
        const double middle = std::sqrt(low * high);
        const TargetError then{error.noise / std::sqrt(middle),
                               error.bias * std::pow(middle, alpha - 1)};
        (then.value() > target ? low : high) = middle;
    }
    return high;
}

double passes_left(const Film& film, const TargetError& error, double target, double alpha) {
    const std::uint64_t latest = film.passes().ranges().back().end - 1;
    const double weight = film.weight_of_batch(latest / kBatchPasses);
    return (times_passes_to(error, target, alpha) - 1) * film.weight() / weight;
}

std::optional<TargetError> target_error(const Film& film, ErrorTerms terms) {
    if (film.batches() < kTargetBatches || is_too_dim(film)) return {};
    const std::vector<BrightBlock> bright = bright_blocks(film);
    if (bright.empty()) return {};
    TargetError error{noise_of(film, bright, terms.extrapolated), 0};
    if (terms.bias && !terms.extrapolated) error.bias = bias_of(film, bright).value_or(0);
    return error;
}

std::optional<double> relative_bias(const Film& film) {
    const std::vector<BrightBlock> bright = bright_blocks(film);
    if (bright.empty()) return {};
    return bias_of(film, bright);
}

}  // namespace sunfleck::engine
