// Weighted sums over neighbours, row by row.
#include "planning/pixel_buffer.h"

#include "core/parallel.h"
#include "film/luminance.h"

#include <algorithm>
#include <numeric>

namespace sunfleck::engine {
namespace {

/// Returns the weight of a pixel's neighbour along an axis.
double weight_of(int there, int here) {
    return there == here ? 2 : 1;
}

}  // namespace

PixelValues luminance_of(const PassImage& image) {
    PixelValues pixels(image.pixels());
    parallel_blocks(pixels.size(), 1U << 14U, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const RgbSum sum{{image.value(Aov::total, i, 0), image.value(Aov::total, i, 1),
                              image.value(Aov::total, i, 2)}};
            pixels[i] = sum.mean_luminance(1);
        }
    });
    return pixels;
}

double mean_value(const PixelValues& pixels) {
    return std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
}

PixelValues smoothed(const PixelValues& pixels, const PixelWindow& window) {
    const int width = window.width();
    const int height = window.height();
    PixelValues result;
    result.reserve(pixels.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            double weights = 0;
            for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
                for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u) {
                    const double weight = weight_of(u, x) * weight_of(v, y);
                    sum += weight * pixels[static_cast<std::size_t>(v * width + u)];
                    weights += weight;
                }
            result.push_back(sum / weights);
        }
    return result;
}

PixelValues upsampled(const PixelValues& pixels, const PixelCells& cells) {
    PixelValues few;
    for (int y = 0; y < cells.down(); ++y)
        for (int x = 0; x < cells.across(); ++x) few.push_back(pixels[cells.pixel_of(x, y)]);
    few = smoothed(few, {0, 0, cells.across(), cells.down()});
    PixelValues all;
    all.reserve(pixels.size());
    for (int y = 0; y < cells.window.height(); ++y)
        for (int x = 0; x < cells.window.width(); ++x)
            all.push_back(
                few[static_cast<std::size_t>(y / cells.side * cells.across() + x / cells.side)]);
    return all;
}

}  // namespace sunfleck::engine
