// Quantiles and means over blocks.
#include "film/target_error.h"

#include "film/bias.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sunfleck::engine {
namespace {

struct CountedBlock {
    std::size_t number;
    MeanError luminance;
    double scale;  // of its errors
};

struct CountedBlocks {
    std::vector<CountedBlock> bright;
    std::vector<CountedBlock> dark;
};

CountedBlocks counted_blocks(const Film& film, Objective objective) {
    CountedBlocks counted;
    const auto image = image_error(film);
    if (!image || !(image->mean > 0)) return counted;
    const std::vector<MeanError> blocks = block_errors(film);
    for (std::size_t b = 0; b < blocks.size(); ++b)
        if (objective == Objective::absolute)
            counted.bright.push_back({b, blocks[b], image->mean});
        else if (blocks[b].mean > kDarkestThatCounts * image->mean)
            counted.bright.push_back({b, blocks[b], blocks[b].mean});
        else if (blocks[b].mean > kDarkest * image->mean)
            counted.dark.push_back({b, blocks[b], blocks[b].mean});
    return counted;
}

/// @param counted  at least one block. @param errors  of all blocks less their bias; empty for
/// those of the blocks themselves.
double noise_of(const Film& film, const std::vector<CountedBlock>& counted,
                const std::vector<double>& errors) {
    std::vector<double> scaled;
    for (const CountedBlock& block : counted) {
        const double error = errors.empty() ? block.luminance.standard_error : errors[block.number];
        scaled.push_back(error / block.scale);
    }
    std::sort(scaled.begin(), scaled.end());
    const double wider = errors.empty() ? widening(film) : line_widening(film);
    return wider * scaled[(scaled.size() * 95 + 99) / 100 - 1];
}

/// @param counted  at least one block. @param biases  of all blocks; empty if they are unknown.
std::optional<double> bias_of(const std::vector<CountedBlock>& counted,
                              const std::vector<Bias>& biases) {
    if (biases.empty()) return {};
    double sum = 0;
    for (const CountedBlock& block : counted) {
        const Bias& bias = biases[block.number];
        const double square = bias.value * bias.value - bias.standard_error * bias.standard_error;
        sum += square / (block.scale * block.scale);
    }
    return std::sqrt(std::max(0.0, sum / static_cast<double>(counted.size())));
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
    return (times_passes_to(error, target, alpha) - 1) * film.weight();
}

std::optional<TargetError> target_error(const Film& film, ErrorTerms terms) {
    if (film.batches().count < kTargetBatches || is_too_dim(film)) return {};
    const CountedBlocks counted = counted_blocks(film, terms.objective);
    if (counted.bright.empty()) return {};
    const auto extrapolated =
        terms.extrapolated ? extrapolated_block_errors(film) : std::vector<double>();
    const auto biases =
        terms.bias && !terms.extrapolated ? block_biases(film) : std::vector<Bias>();
    const auto error_of = [&](const std::vector<CountedBlock>& blocks) {
        return TargetError{noise_of(film, blocks, extrapolated),
                           bias_of(blocks, biases).value_or(0)};
    };
    TargetError error = error_of(counted.bright);
    if (!counted.dark.empty()) error.of_dark = error_of(counted.dark).value();
    return error;
}

std::optional<double> relative_bias(const Film& film) {
    const CountedBlocks counted = counted_blocks(film, Objective::relative);
    if (counted.bright.empty()) return {};
    return bias_of(counted.bright, block_biases(film));
}

}  // namespace sunfleck::engine
