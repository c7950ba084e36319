// Slopes over disc areas, and their residuals.
#include "film/bias.h"

#include "core/parallel.h"
#include "film/luminance.h"
#include "math/wavelengths.h"
#include "visible_points/radius.h"

#include <algorithm>
#include <cmath>

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
    double variance = 0;  // residual variance of a batch
};

/// Returns the residual variance of a batch, from the sum of squares around the mean and the slope;
/// the fit takes two degrees of freedom.
double residual_variance(double squares, double slope, const DiscAreas& areas) {
    return std::max(0.0, squares - slope * slope * areas.squares) / (areas.batches - 2);
}

Line line_through(const BatchMeans& y, const DiscAreas& areas) {
    const double slope = (y.mean_by_area - areas.mean * y.mean) * areas.batches / areas.squares;
    const double squares = (y.mean_square - y.mean * y.mean) * areas.batches;
    return {slope, residual_variance(squares, slope, areas)};
}

Bias bias_of(const BatchMeans& y, const DiscAreas& areas) {
    const Line line = line_through(y, areas);
    return {line.slope * areas.mean_of_passes, std::sqrt(line.variance * areas.bias_variance())};
}

/// Returns means over complete batches of each block, summed over its pixels, without squares.
std::vector<BatchMeans> block_sums(const Film& film, const BlockGrid& grid) {
    const FilmSums& sums = film.sums();
    const double passes = film.complete_passes();
    std::vector<std::pair<double, const FixedPoints*>> open;  // area, sums
    for (const auto& [first, group] : sums.open_groups)
        open.emplace_back(batch_area(first / kBatchPasses, film.key().alpha), &group.photon_blocks);
    std::vector<BatchMeans> result(grid.count());
    parallel_for(grid.count(), [&](std::size_t b) {
        RgbSum light;
        RgbSum by_area;
        grid.for_pixels(b, [&](std::size_t pixel) {
            light += rgb_of(sums.photons.rgb, pixel);
            by_area += rgb_of(sums.photons.rgb_by_area, pixel);
        });
        double of_open = 0;
        for (const auto& [area, blocks] : open) {
            const RgbSum part = rgb_of(*blocks, b);
            light -= part;
            of_open += area * part.mean_luminance(1);
        }
        result[b].mean = light.mean_luminance(passes);
        result[b].mean_by_area = (by_area.mean_luminance(1) - of_open) / passes;
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
    const BlockGrid grid(film.key(), kErrorBlock);
    const std::vector<BatchMeans> sums = block_sums(film, grid);
    const FixedPoints& squares = film.sums().photons.block_squares;
    const auto batches = static_cast<double>(film.batches());
    for (std::size_t b = 0; b < grid.count(); ++b)
        visit(b, means(sums[b], grid.block(b).pixels(), squares[b].to_double() / batches));
}

/// Returns the variance of a mean minus its bias; the errors of mean and slope are uncorrelated.
/// @param batch  variance of the luminance of a batch.
/// @param photons  variance of the photons' luminance.
double extrapolated_error(double batch, double photons, const DiscAreas& areas) {
    return std::sqrt(batch / areas.batches + photons * areas.bias_variance());
}

/// Returns the sum of squares of a quantity around its mean.
double squares_around_mean(const MeanError& error, const DiscAreas& areas) {
    return error.standard_error * error.standard_error * areas.batches * (areas.batches - 1);
}

}  // namespace

std::vector<std::array<double, 3>> pixel_biases(const Film& film) {
    const auto areas = disc_areas(film);
    if (!areas) return {};
    const PhotonSums& sums = film.sums().photons;
    const double scale = areas->mean_of_passes / areas->divisor;
    std::vector<std::array<double, 3>> biases(film.key().pixels());
    parallel_blocks(biases.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = 3 * begin; i < 3 * end; ++i)
            biases[i / 3][i % 3] =
                (sums.rgb_by_area[i].to_double() - areas->share * sums.rgb[i].to_double()) * scale;
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
    for (const BatchMeans& block : block_sums(film, BlockGrid(film.key(), kErrorBlock))) {
        total.mean += block.mean;
        total.mean_by_area += block.mean_by_area;
    }
    if (total.mean == 0 && is_lit(film.sums().aovs[0])) return {};
    const double square = film.sums().photons.image_square.to_double() / areas->batches;
    return bias_of(means(total, film.key().pixels(), square), *areas);
}

std::vector<double> extrapolated_pixel_errors(const Film& film) {
    const auto areas = disc_areas(film);
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
    const auto areas = disc_areas(film);
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
