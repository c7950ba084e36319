// Means over complete batches: the totals less the batches that are still open, exactly.
#include "film/error_bars.h"

#include "core/parallel.h"
#include "film/luminance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Exact sum of a pixel over the passes of complete batches.
RgbSum complete_sum(const FilmSums& sums, std::size_t pixel) {
    RgbSum rgb = rgb_of(sums.aovs[0], pixel);
    for (const auto& [first, group] : sums.open_groups) rgb -= rgb_of(group.aovs[0], pixel);
    return rgb;
}

/// Complete batches: their number, and how often they count.
struct CompleteBatches {
    explicit CompleteBatches(const Film& film)
        : count(static_cast<double>(film.batches())), weight(film.weight_of_batches()) {}

    double count;
    double weight;
};

MeanError mean_error(double mean, const FixedPoint& squares, const CompleteBatches& batches) {
    const double variance = squares.to_double() / batches.weight - mean * mean;
    return {mean, std::sqrt(std::max(0.0, variance) / (batches.count - 1))};
}

/// Luminance of each block, summed over its pixels, for `passes` passes.
template <class PixelSum>
std::vector<double> block_sums(const BlockGrid& grid, double passes, const PixelSum& pixel_sum) {
    std::vector<double> sums(grid.count());
    parallel_for(grid.count(), [&](std::size_t b) {
        RgbSum block;
        grid.for_pixels(b, [&](std::size_t pixel) { block += pixel_sum(pixel); });
        sums[b] = block.mean_luminance(passes);
    });
    return sums;
}

double total(const std::vector<double>& terms) {
    double sum = 0;
    for (const double term : terms) sum += term;
    return sum;
}

std::vector<double> complete_block_sums(const Film& film) {
    return block_sums(BlockGrid(film.key(), kErrorBlock), film.complete_weight(),
                      [&](std::size_t pixel) { return complete_sum(film.sums(), pixel); });
}

/// Of all pixels. @param rgb  of each, over passes.
double mean_luminance(const Film& film, const FixedPoints& rgb) {
    if (film.pass_count() == 0) return 0;
    const BlockGrid grid(film.key(), kErrorBlock);
    const std::vector<double> sums =
        block_sums(grid, film.weight(), [&](std::size_t pixel) { return rgb_of(rgb, pixel); });
    return total(sums) / static_cast<double>(film.key().pixels());
}

}  // namespace

/// With variances in proportion to one over the weights w the sum of w (y - m)^2 has the
/// distribution of chi-square with n - 1 degrees. With equal variances its mean and variance are
/// those of chi-square with trace(A)^2 / trace(A^2) degrees, A = diag(w) - w w^T / sum(w).
double error_degrees(const Film& film) {
    std::array<double, 4> powers{};  // sums of w^0, w, w^2, w^3
    const auto add = [&](double batches, double weight) {
        for (double& power : powers) {
            power += batches;
            batches *= weight;
        }
    };
    auto light = static_cast<double>(film.batches());
    for (const auto& [weight, passes] : film.sums().heavy) {
        const auto batches = static_cast<double>(complete_batches(passes));
        add(batches, weight);
        light -= batches;
    }
    add(light, 1);
    const double mean = powers[2] / powers[1];
    const double trace = powers[1] - mean;
    return trace * trace / (powers[2] - 2 * powers[3] / powers[1] + mean * mean);
}

bool is_lit(const FixedPoints& sums) {
    return std::any_of(sums.begin(), sums.end(),
                       [](FixedPoint sum) { return sum != FixedPoint{}; });
}

std::vector<MeanError> pixel_errors(const Film& film) {
    const CompleteBatches batches(film);
    if (batches.count < 2) return {};
    const double passes = film.complete_weight();
    std::vector<MeanError> errors(film.key().pixels());
    parallel_blocks(errors.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double mean = complete_sum(film.sums(), i).mean_luminance(passes);
            errors[i] = mean_error(mean, film.sums().pixel_squares[i], batches);
            // All light of one batch of n has the standard error of its mean, whatever n is.
            if (mean == 0 && errors[i].standard_error == 0)
                errors[i].standard_error =
                    std::abs(rgb_of(film.sums().aovs[0], i).mean_luminance(film.weight()));
        }
    });
    return errors;
}

std::vector<MeanError> block_errors(const Film& film) {
    const CompleteBatches batches(film);
    if (batches.count < 2) return {};
    const BlockGrid grid(film.key(), kErrorBlock);
    const std::vector<double> sums = complete_block_sums(film);
    std::vector<MeanError> errors(grid.count());
    for (std::size_t b = 0; b < errors.size(); ++b) {
        const double mean = sums[b] / static_cast<double>(grid.block(b).pixels());
        errors[b] = mean_error(mean, film.sums().block_squares[b], batches);
    }
    return errors;
}

std::optional<MeanError> image_error(const Film& film) {
    const CompleteBatches batches(film);
    if (batches.count < 2) return {};
    const double mean = total(complete_block_sums(film)) / static_cast<double>(film.key().pixels());
    if (mean == 0 && is_lit(film.sums().aovs[0])) return {};
    return mean_error(mean, film.sums().image_square, batches);
}

double image_mean(const Film& film) {
    if (film.pass_count() == 0) return 0;
    const BlockGrid grid(film.key(), kErrorBlock);
    const auto sum_of = [&](const FixedPoints& rgb) {
        return total(block_sums(grid, film.picture_weight(),
                                [&](std::size_t pixel) { return rgb_of(rgb, pixel); }));
    };
    double sum = sum_of(film.sums().aovs[0]);
    for (const auto& [first, group] : film.sums().open_groups)
        sum -= (1 - film.share_of_pass(first)) * sum_of(group.aovs[0]);
    return sum / static_cast<double>(film.key().pixels());
}

double image_mean_by_photons(const Film& film) {
    const FixedPoints& rgb = film.sums().photons.rgb;
    return rgb.empty() ? 0 : mean_luminance(film, rgb);
}

}  // namespace sunfleck::engine
