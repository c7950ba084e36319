// Slopes over disc areas, and their residuals.
#include "film/bias.h"

#include "core/parallel.h"
#include "film/batch_sums.h"
#include "film/luminance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Photons' luminance over complete batches, of a block or the picture.
struct BatchMeans {
    double mean = 0;
    double mean_by_area = 0;
    double mean_square = 0;
};

/// The regression line through complete batches.
struct Line {
    double slope = 0;
    double variance = 0;  // residual variance of a pass
};

/// Returns the residual variance of a pass, from the sum of squares around the mean and the slope;
/// the fit takes two degrees of freedom.
double residual_variance(double squares, double slope, const DiscAreas& areas) {
    return std::max(0.0, squares - slope * slope * areas.squares) / (areas.complete.count - 2);
}

Line line_through(const BatchMeans& y, const DiscAreas& areas) {
    const double passes = areas.complete.passes;
    const double slope = (y.mean_by_area - areas.mean * y.mean) * passes / areas.squares;
    const double squares = (y.mean_square - y.mean * y.mean) * passes;
    return {slope, residual_variance(squares, slope, areas)};
}

Bias bias_of(const BatchMeans& y, const DiscAreas& areas) {
    const Line line = line_through(y, areas);
    return {line.slope * areas.mean_of_passes, std::sqrt(line.variance * areas.bias_variance())};
}

/// Returns means over complete batches of each block, summed over its pixels, without squares.
std::vector<BatchMeans> block_sums(const Film& film) {
    const FilmSums& sums = film.sums();
    const BlockGrid blocks = blocks_of_cells(film.key(), kErrorBlock);
    const double passes = film.batches().passes;
    std::vector<std::pair<double, const FixedPoints*>> open;  // area, sums
    for (const OpenPasses& group : passes_left_out(sums))
        open.emplace_back(area_of(film.key(), batch_range(group.first / kBatchPasses)),
                          &group.sums->photon_blocks);
    const FixedPoints& early = sums.early.photon_blocks_by_area;
    std::vector<BatchMeans> result(blocks.count());
    parallel_for(blocks.count(), [&](std::size_t b) {
        RgbSum light;
        RgbSum by_area;
        blocks.for_pixels(b, [&](std::size_t cell) {
            light += rgb_of(sums.photons.rgb, cell);
            by_area += rgb_of(sums.photons.rgb_by_area, cell);
        });
        double complete = by_area.mean_luminance(1);
        for (const auto& [area, group] : open) {
            const RgbSum part = rgb_of(*group, b);
            light -= part;
            complete -= area * part.mean_luminance(1);
        }
        if (!early.empty()) complete += early[b].to_double();
        result[b].mean = light.mean_luminance(passes);
        result[b].mean_by_area = complete / passes;
    });
    return result;
}

/// Returns means per pixel of a block, or of the picture.
BatchMeans means(const BatchMeans& sums, std::size_t pixels, double mean_square) {
    const auto n = static_cast<double>(pixels);
    return {sums.mean / n, sums.mean_by_area / n, mean_square};
}

/// Calls visit(block, its means) for each block.
template <class Visit>
void for_blocks(const Film& film, const Visit& visit) {
    const BlockGrid grid = blocks_of(film.key(), kErrorBlock);
    const std::vector<BatchMeans> sums = block_sums(film);
    const FixedPoints& squares = film.sums().photons.block_squares;
    const FixedPoints& early = film.sums().early.photon_block_squares;
    const double passes = film.batches().passes;
    for (std::size_t b = 0; b < grid.count(); ++b)
        visit(b, means(sums[b], grid.block(b).pixels(), square_sum(squares, early, b) / passes));
}

/// Returns the variance of a mean minus its bias; the errors of mean and slope are uncorrelated.
/// @param pass  variance of the luminance of a pass.
/// @param photons  variance of the photons' luminance.
double extrapolated_error(double pass, double photons, const DiscAreas& areas) {
    return std::sqrt(pass / areas.complete.passes + photons * areas.bias_variance());
}

/// Returns the sum of squares of a quantity around its mean.
double squares_around_mean(const MeanError& error, const DiscAreas& areas) {
    const CompleteBatches& all = areas.complete;
    return error.standard_error * error.standard_error * all.passes * (all.count - 1);
}

/// Returns nothing as long as early batches count.
std::optional<DiscAreas> areas_of_whole_batches(const Film& film) {
    if (has_early_batches(film.passes())) return {};
    return disc_areas(film);
}

}  // namespace

bool has_pixel_biases(const Film& film) {
    return areas_of_whole_batches(film).has_value();
}

std::vector<std::array<double, 3>> pixel_biases(const Film& film) {
    const auto areas = areas_of_whole_batches(film);
    if (!areas) return {};
    const PhotonSums& sums = film.sums().photons;
    const double scale = areas->mean_of_passes / areas->divisor;
    const BlockGrid cells = photon_cells_of(film.key());
    std::vector<std::array<double, 3>> biases(film.key().pixels());
    parallel_blocks(cells.count(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell) {
            std::array<double, 3> bias{};
            for (std::size_t c = 0; c < 3; ++c) {
                const double light = sums.rgb[3 * cell + c].to_double();
                const double by_area = sums.rgb_by_area[3 * cell + c].to_double();
                bias.at(c) = (by_area - areas->share * light) * scale /
                             static_cast<double>(cells.block(cell).pixels());
            }
            cells.for_pixels(cell, [&](std::size_t pixel) { biases[pixel] = bias; });
        }
    });
    return biases;
}

std::vector<Bias> block_biases(const Film& film) {
    const auto areas = disc_areas(film);
    if (!areas) return {};
    std::vector<Bias> biases;
    for_blocks(film,
               [&](std::size_t, const BatchMeans& y) { biases.push_back(bias_of(y, *areas)); });
    return biases;
}

std::optional<Bias> image_bias(const Film& film) {
    const auto areas = disc_areas(film);
    if (!areas) return {};
    BatchMeans total;
    for (const BatchMeans& block : block_sums(film)) {
        total.mean += block.mean;
        total.mean_by_area += block.mean_by_area;
    }
    if (total.mean == 0 && is_lit(film.sums().aovs[0])) return {};
    const FilmSums& sums = film.sums();
    const double squares = square_sum(sums.photons.image_square, sums.early.photon_image_square);
    const double mean_square = squares / areas->complete.passes;
    return bias_of(means(total, film.key().pixels(), mean_square), *areas);
}

std::vector<double> extrapolated_pixel_errors(const Film& film) {
    const auto areas = areas_of_whole_batches(film);
    if (!areas) return {};
    const std::vector<MeanError> plain = pixel_errors(film);
    const auto biases = pixel_biases(film);
    std::vector<double> errors(plain.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const double slope = luminance(biases[i]) / areas->mean_of_passes;
        const double squares = squares_around_mean(plain[i], *areas);
        const double variance = residual_variance(squares, slope, *areas);
        errors[i] = extrapolated_error(variance, variance, *areas);
    }
    return errors;
}

std::vector<double> extrapolated_block_errors(const Film& film) {
    const auto areas = areas_of_whole_batches(film);
    if (!areas) return {};
    const std::vector<MeanError> plain = block_errors(film);
    std::vector<double> errors(plain.size());
    for_blocks(film, [&](std::size_t b, const BatchMeans& y) {
        const Line line = line_through(y, *areas);
        const double squares = squares_around_mean(plain[b], *areas);
        errors[b] = extrapolated_error(residual_variance(squares, line.slope, *areas),
                                       line.variance, *areas);
    });
    return errors;
}

}  // namespace sunfleck::engine
