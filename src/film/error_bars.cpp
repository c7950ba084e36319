// Means over complete batches: totals minus open batches, exactly.
#include "film/error_bars.h"

#include "core/parallel.h"
#include "film/batch_sums.h"
#include "film/luminance.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Exact sums of pixels over the passes of complete batches.
class CompleteSums {
public:
    explicit CompleteSums(const FilmSums& sums) : sums_(sums), left_out_(passes_left_out(sums)) {}

    RgbSum operator[](std::size_t pixel) const {
        RgbSum rgb = rgb_of(sums_.aovs[0], pixel);
        for (const OpenPasses& open : left_out_) rgb -= rgb_of(open.sums->aovs[0], pixel);
        return rgb;
    }

private:
    const FilmSums& sums_;
    std::vector<OpenPasses> left_out_;
};

/// @param squares  of the means of batches, each times the passes of its batch.
MeanError mean_error(double mean, double squares, const CompleteBatches& batches) {
    const double variance = squares / batches.passes - mean * mean;
    return {mean, std::sqrt(std::max(0.0, variance) / (batches.count - 1))};
}

/// Returns the luminance of each block, summed over its pixels, over `passes` passes.
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
    const CompleteSums sums(film.sums());
    return block_sums(blocks_of(film.key(), kErrorBlock), film.batches().passes,
                      [&](std::size_t pixel) { return sums[pixel]; });
}

}  // namespace

bool is_lit(const FixedPoints& sums) {
    return std::any_of(sums.begin(), sums.end(),
                       [](FixedPoint sum) { return sum != FixedPoint{}; });
}

std::vector<MeanError> pixel_errors(const Film& film) {
    const CompleteBatches batches = film.batches();
    if (batches.count < 2) return {};
    const FilmSums& sums = film.sums();
    const CompleteSums complete(sums);
    const double all_passes = film.weight();
    std::vector<MeanError> errors(film.key().pixels());
    parallel_blocks(errors.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double mean = complete[i].mean_luminance(batches.passes);
            const double squares = square_sum(sums.pixel_squares, sums.early.pixel_squares, i);
            errors[i] = mean_error(mean, squares, batches);
            // If all light is in one of n batches, the standard error equals the mean, whatever n
            // is.
            if (mean == 0 && errors[i].standard_error == 0)
                errors[i].standard_error =
                    std::abs(rgb_of(sums.aovs[0], i).mean_luminance(all_passes));
        }
    });
    return errors;
}

std::vector<MeanError> block_errors(const Film& film) {
    const CompleteBatches batches = film.batches();
    if (batches.count < 2) return {};
    const FilmSums& sums = film.sums();
    const BlockGrid grid = blocks_of(film.key(), kErrorBlock);
    const std::vector<double> means = complete_block_sums(film);
    std::vector<MeanError> errors(grid.count());
    for (std::size_t b = 0; b < errors.size(); ++b) {
        const double mean = means[b] / static_cast<double>(grid.block(b).pixels());
        const double squares = square_sum(sums.block_squares, sums.early.block_squares, b);
        errors[b] = mean_error(mean, squares, batches);
    }
    return errors;
}

std::optional<MeanError> image_error(const Film& film) {
    const CompleteBatches batches = film.batches();
    if (batches.count < 2) return {};
    const FilmSums& sums = film.sums();
    const double mean = total(complete_block_sums(film)) / static_cast<double>(film.key().pixels());
    if (mean == 0 && is_lit(sums.aovs[0])) return {};
    return mean_error(mean, square_sum(sums.image_square, sums.early.image_square), batches);
}

double image_mean(const Film& film) {
    if (film.pass_count() == 0) return 0;
    const BlockGrid grid = blocks_of(film.key(), kErrorBlock);
    const auto sum_of = [&](const FixedPoints& rgb) {
        return total(block_sums(grid, film.passes_in_picture(),
                                [&](std::size_t pixel) { return rgb_of(rgb, pixel); }));
    };
    double sum = sum_of(film.sums().aovs[0]);
    for (const auto& [first, group] : film.sums().open_groups)
        sum -= (1 - film.share_of_pass(first)) * sum_of(group.aovs[0]);
    return sum / static_cast<double>(film.key().pixels());
}

double image_mean_by_photons(const Film& film) {
    const FixedPoints& rgb = film.sums().photons.rgb;
    if (rgb.empty() || film.pass_count() == 0) return 0;
    RgbSum sum;
    for (std::size_t cell = 0; 3 * cell < rgb.size(); ++cell) sum += rgb_of(rgb, cell);
    return sum.mean_luminance(film.weight()) / static_cast<double>(film.key().pixels());
}

}  // namespace sunfleck::engine
