// Terms of a film's sums, in parallel: each sum belongs to one task.
#include "film/pass_terms.h"

#include "core/parallel.h"
#include "film/luminance.h"
#include "math/wavelengths.h"

#include <atomic>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kPixelsPerTask = 1U << 14U;

/// Conversion of numbers to exact sums, with clamping of large ones.
class Terms {
public:
    FixedPoint operator()(double x) {
        const double term = cut_term(x);
        if (term != x) cut_.fetch_add(1, std::memory_order_relaxed);
        return FixedPoint::from_double(term);
    }
    std::uint64_t cut() const { return cut_.load(); }

private:
    std::atomic<std::uint64_t> cut_{0};
};

/// Adds the squares of a quantity's mean luminance in each block of a complete batch.
/// @param block_sum  of a block, over its pixels.
/// @param square  term of a luminance.
/// @return the square of the picture's mean.
template <class BlockSum, class Square>
FixedPoint add_block_squares(const BlockGrid& grid, const BlockSum& block_sum, const Square& square,
                             FixedPoints& squares) {
    double total = 0;
    std::size_t pixels = 0;
    for (std::size_t b = 0; b < grid.count(); ++b) {
        const double sum = block_sum(b);
        const double mean = sum / static_cast<double>(grid.block(b).pixels());
        squares[b] += square(mean);
        total += sum;
        pixels += grid.block(b).pixels();
    }
    const double mean = total / static_cast<double>(pixels);
    return square(mean);
}

}  // namespace

void add_all(std::span<FixedPoint> sums, std::span<const FixedPoint> terms) {
    parallel_blocks(sums.size(), kPixelsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) sums[i] += terms[i];
    });
}

void add_aov(FixedPoints& sums, const WeighedImage& pass, const AovRow& row) {
    const std::size_t channels = row.channels.size();
    parallel_blocks(sums.size(), kPixelsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            sums[i] +=
                pass.image.value(row.aov, i / channels, i % channels).shifted_down(pass.bits_less);
    });
}

void add_light_group(FixedPoints& sums, const WeighedImage& pass, std::size_t light_group) {
    parallel_blocks(sums.size(), kPixelsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            sums[i] +=
                pass.image.light_value(light_group, i / 3, i % 3).shifted_down(pass.bits_less);
    });
}

std::uint64_t add_photons(FilmSums& sums, const WeighedImage& pass, double area, OpenGroup& group) {
    const BlockGrid blocks = blocks_of_cells(sums.key, kErrorBlock);
    Terms term;
    const auto add_cell = [&](std::size_t cell, const RgbSum& light) {
        for (std::size_t c = 0; c < 3; ++c) {
            sums.photons.rgb[3 * cell + c] += light.channel[c];
            sums.photons.rgb_by_area[3 * cell + c] += term(light.channel[c].to_double() * area);
        }
    };
    parallel_for(blocks.count(), [&](std::size_t b) {
        RgbSum block;
        blocks.for_pixels(b, [&](std::size_t cell) {
            RgbSum light;
            for (std::size_t c = 0; c < 3; ++c)
                light.channel[c] = pass.image.by_photons(cell, c).shifted_down(pass.bits_less);
            add_cell(cell, light);
            block += light;
        });
        for (std::size_t c = 0; c < 3; ++c) group.photon_blocks[3 * b + c] += block.channel[c];
    });
    return term.cut();
}

SquareSums squares_of_whole(FilmSums& sums) {
    return {sums.pixel_squares, sums.block_squares, sums.image_square, sums.photons.block_squares,
            sums.photons.image_square};
}

SquareSums squares_of_early(FilmSums& sums) {
    EarlySums& early = sums.early;
    return {early.pixel_squares, early.block_squares, early.image_square,
            early.photon_block_squares, early.photon_image_square};
}

std::uint64_t add_squares(const FilmKey& key, const OpenGroup& batch, double passes, double factor,
                          const SquareSums& sums) {
    const BlockGrid grid = blocks_of(key, kErrorBlock);
    std::vector<double> luminance(grid.count());  // over the block's pixels
    Terms term;
    const auto square = [&](double y) { return term(factor * (y * y)); };
    parallel_for(grid.count(), [&](std::size_t b) {
        RgbSum block;
        grid.for_pixels(b, [&](std::size_t pixel) {
            const RgbSum rgb = rgb_of(batch.aovs[0], pixel);
            sums.pixels[pixel] += square(rgb.mean_luminance(passes));
            block += rgb;
        });
        luminance[b] = block.mean_luminance(passes);
    });
    sums.image += add_block_squares(
        grid, [&](std::size_t b) { return luminance[b]; }, square, sums.blocks);
    if (!key.has_discs()) return term.cut();
    sums.photon_image += add_block_squares(
        grid, [&](std::size_t b) { return rgb_of(batch.photon_blocks, b).mean_luminance(passes); },
        square, sums.photon_blocks);
    return term.cut();
}

std::uint64_t add_early_area(FilmSums& sums, const OpenGroup& batch, double area) {
    Terms term;
    FixedPoints& by_area = sums.early.photon_blocks_by_area;
    for (std::size_t b = 0; b < by_area.size(); ++b)
        by_area[b] += term(rgb_of(batch.photon_blocks, b).mean_luminance(1) * area);
    return term.cut();
}

}  // namespace sunfleck::engine
