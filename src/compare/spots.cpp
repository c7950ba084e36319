// Counts of spots.
#include "compare/spots.h"

#include "compare/relative_square.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kReach = 2;  // pixels to each side
constexpr double kFactor = 3;
constexpr double kWorst = 0.001;  // of the pixels

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double largest_around(std::span<const double> pixels, std::size_t width, std::size_t x,
                      std::size_t y) {
    const std::size_t height = pixels.size() / width;
    double largest = 0;
    for (std::size_t j = y - std::min(y, kReach); j < std::min(height, y + kReach + 1); ++j)
        for (std::size_t i = x - std::min(x, kReach); i < std::min(width, x + kReach + 1); ++i)
            largest = std::max(largest, pixels[j * width + i]);
    return largest;
}

}  // namespace

Spots spots_of(std::span<const double> reference, std::span<const double> pixels,
               std::size_t width) {
    Spots spots;
    const double picture = mean_of(reference);
    std::vector<double> squares(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const double difference = pixels[i] - reference[i];
        squares[i] = relative_square(difference * difference, reference[i], picture);
        if (pixels[i] <= picture) continue;
        const double around = largest_around(reference, width, i % width, i / width);
        spots.count += pixels[i] > kFactor * around ? 1 : 0;
    }
    const double all = std::accumulate(squares.begin(), squares.end(), 0.0);
    const auto worst = static_cast<std::ptrdiff_t>(kWorst * static_cast<double>(squares.size()));
    std::nth_element(squares.begin(), squares.begin() + worst, squares.end(), std::greater<>());
    if (all > 0)
        spots.worst_share = std::accumulate(squares.begin(), squares.begin() + worst, 0.0) / all;
    return spots;
}

}  // namespace sunfleck::engine
