// Sums of Gaussians by box filters with running sums, rows first, then columns.
#include "image/glare.h"

#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sunfleck::engine {
namespace {

constexpr double kDegreesAcross = 40;  // of the longer side
constexpr double kLeastDegrees = 0.1;  // standard deviation of the narrowest Gaussian
constexpr std::size_t kGaussians = 8;  // each twice as wide as the one before: up to 12.8
constexpr int kBoxes = 4;              // filters that make a Gaussian
constexpr double kCubeInGaussians = 0.797884560802865;  // sqrt(2/pi): 1/t^3 in terms of 1/t^2

/// A box with fractions at its ends: weight 1 within `radius` of the middle, `edge` beside it.
struct Box {
    std::size_t radius = 0;
    double edge = 0;

    double width() const { return 2 * static_cast<double>(radius) + 1 + 2 * edge; }
};

/// Returns the box of this variance, in pixels squared.
/// Source: Gwosdek et al., Theoretical Foundations of Gaussian Convolution by Extended Box
/// Filtering (2011), solved for the fraction.
Box box_of(double variance) {
    const double whole = std::floor((std::sqrt(1 + 12 * variance) - 1) / 2);
    const double next = whole + 1;
    const double edge =
        (2 * whole + 1) * (whole * next / 3 - variance) / (2 * (variance - next * next));
    return {static_cast<std::size_t>(whole), edge};
}

/// Filters a row, in double, with its mirror images beyond both ends.
/// @param row  its values, which are replaced.
/// @param padded  room for them.
void filter(std::vector<double>& row, const Box& box, std::vector<double>& padded) {
    const std::size_t reach = box.radius + 1;
    const std::size_t count = row.size();
    padded.resize(count + 2 * reach);
    const std::size_t period = 2 * count;
    for (std::size_t i = 0; i < padded.size(); ++i) {
        const std::size_t at = (i + period * (1 + reach / period) - reach) % period;
        padded[i] = row[std::min(at, period - 1 - at)];
    }
    double inner = 0;
    for (std::size_t i = 1; i < 2 * reach; ++i) inner += padded[i];
    const double scale = 1 / box.width();
    for (std::size_t i = 0; i < count; ++i) {
        row[i] = scale * (inner + box.edge * (padded[i] + padded[i + 2 * reach]));
        inner += padded[i + 2 * reach] - padded[i + 1];
    }
}

void filter_rows(std::vector<float>& light, const Vec2i& size, const Box& box) {
    const auto width = static_cast<std::size_t>(size.x);
    parallel_blocks(static_cast<std::size_t>(size.y), 8, [&](std::size_t begin, std::size_t end) {
        std::vector<double> row(width);
        std::vector<double> padded;
        for (std::size_t y = begin; y < end; ++y) {
            const auto first = light.begin() + static_cast<std::ptrdiff_t>(y * width);
            std::copy_n(first, width, row.begin());
            for (int i = 0; i < kBoxes; ++i) filter(row, box, padded);
            std::transform(row.begin(), row.end(), first,
                           [](double value) { return static_cast<float>(value); });
        }
    });
}

std::vector<float> transposed(const std::vector<float>& light, const Vec2i& size) {
    const auto width = static_cast<std::size_t>(size.x);
    const auto height = static_cast<std::size_t>(size.y);
    std::vector<float> turned(light.size());
    parallel_blocks(width, 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = begin; x < end; ++x) turned[x * height + y] = light[y * width + x];
    });
    return turned;
}

/// Returns the light after a Gaussian. @param deviation  in pixels.
std::vector<float> blurred(std::vector<float> light, const Vec2i& size, double deviation) {
    const Box box = box_of(deviation * deviation / kBoxes);
    filter_rows(light, size, box);
    light = transposed(light, size);
    filter_rows(light, {size.y, size.x}, box);
    return transposed(light, {size.y, size.x});
}

}  // namespace

void add_glare(std::vector<float>& light, const Vec2i& size, double fraction) {
    const double pixels_per_degree = std::max(size.x, size.y) / kDegreesAcross;
    std::array<double, kGaussians> weights{};
    double sum = 0;
    double degrees = kLeastDegrees;
    for (double& weight : weights) {
        weight = kCubeInGaussians / degrees + 1;
        sum += weight;
        degrees *= 2;
    }
    const std::vector<float> source = light;
    for (float& value : light) value *= static_cast<float>(1 - fraction);
    degrees = kLeastDegrees;
    for (const double weight : weights) {
        const auto share = static_cast<float>(fraction * weight / sum);
        const std::vector<float> wide = blurred(source, size, degrees * pixels_per_degree);
        for (std::size_t i = 0; i < light.size(); ++i) light[i] += share * wide[i];
        degrees *= 2;
    }
}

}  // namespace sunfleck::engine
