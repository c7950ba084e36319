// Building the grid in parallel, a column of one hue after the other; looking colours up in it.
#include "math/sigmoid_table.h"

#include "core/parallel.h"
#include "math/sigmoid_fit.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Slow at both ends, where coefficients grow without bound.
double smooth_step(double x) {
    return x * x * (3 - 2 * x);
}

/// Darker than this counts as this dark: black has no coefficients.
constexpr double kDarkest = 1e-6;

/// A place on a grid's axis: the node below, and the part of the way to the next one.
struct Cell {
    std::size_t node;
    float part;
};

Cell cell_of(const std::vector<float>& levels, float level) {
    const auto above = std::upper_bound(levels.begin() + 1, levels.end() - 1, level);
    const auto node = static_cast<std::size_t>(above - levels.begin()) - 1;
    const float part = (level - levels[node]) / (levels[node + 1] - levels[node]);
    return {node, std::max(0.0F, part)};
}

}  // namespace

const SigmoidTable& SigmoidTable::srgb() {
    constexpr std::size_t kResolution = 32;
    static const SigmoidTable table(kResolution);
    return table;
}

SigmoidTable::SigmoidTable(std::size_t resolution)
    : resolution_(resolution), nodes_(3 * resolution * resolution * resolution) {
    for (std::size_t k = 0; k < resolution; ++k) {
        const double share =
            smooth_step(static_cast<double>(k) / static_cast<double>(resolution - 1));
        shares_.push_back(static_cast<float>(share));
        levels_.push_back(static_cast<float>(std::max(kDarkest, smooth_step(share))));
    }
    parallel_for(3 * resolution * resolution, [this](std::size_t column) { fit_column(column); });
}

/// Begins at a middling level, and goes up and down from there.
void SigmoidTable::fit_column(std::size_t column) {
    const std::size_t x = column % resolution_;
    const std::size_t y = column / resolution_ % resolution_;
    const std::size_t largest = column / (resolution_ * resolution_);
    const auto fit = [&](std::size_t k, const Triple* near) {
        Triple rgb{};
        rgb[largest] = levels_[k];
        rgb[(largest + 1) % 3] = double{shares_[x]} * levels_[k];
        rgb[(largest + 2) % 3] = double{shares_[y]} * levels_[k];
        const Triple c = fit_sigmoid_coarsely(rgb, near);
        for (std::size_t i = 0; i < 3; ++i) node(largest, k, y, x).at(i) = static_cast<float>(c[i]);
        return c;
    };
    const std::size_t middle = resolution_ / 2;
    const Triple first = fit(middle, nullptr);
    Triple last = first;
    for (std::size_t k = middle + 1; k < resolution_; ++k) last = fit(k, &last);
    last = first;
    for (std::size_t k = middle; k-- > 0;) last = fit(k, &last);
}

std::array<float, 3> SigmoidTable::coefficients(const Vec3& rgb) const {
    const int largest = rgb.x >= rgb.y ? (rgb.x >= rgb.z ? 0 : 2) : (rgb.y >= rgb.z ? 1 : 2);
    const float level = rgb[largest];
    const Cell x = cell_of(shares_, rgb[(largest + 1) % 3] / level);
    const Cell y = cell_of(shares_, rgb[(largest + 2) % 3] / level);
    const Cell z = cell_of(levels_, level);
    const std::size_t row = resolution_;
    const std::size_t plane = row * row;
    const auto* corner = &nodes_[static_cast<std::size_t>(largest) * plane * row + z.node * plane +
                                 y.node * row + x.node];
    std::array<float, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto along_x = [&](std::size_t offset) {
            return corner[offset][i] * (1 - x.part) + corner[offset + 1][i] * x.part;
        };
        const float low = along_x(0) * (1 - y.part) + along_x(row) * y.part;
        const float high = along_x(plane) * (1 - y.part) + along_x(plane + row) * y.part;
        result.at(i) = low * (1 - z.part) + high * z.part;
    }
    return result;
}

SampledSpectrum SigmoidTable::albedo(const Vec3& rgb, const Wavelengths& wavelengths) const {
    const Vec3 colour(std::clamp(rgb.x, 0.0F, 1.0F), std::clamp(rgb.y, 0.0F, 1.0F),
                      std::clamp(rgb.z, 0.0F, 1.0F));
    if (colour.x == colour.y && colour.y == colour.z) return SampledSpectrum(colour.x);
    const std::array<float, 3> c = coefficients(colour);
    SampledSpectrum result;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        const float t =
            (wavelengths.nm[i] - static_cast<float>(kMiddleNm)) / static_cast<float>(kHalfRangeNm);
        const float x = c[0] + t * (c[1] + t * c[2]);
        result[i] = 0.5F + 0.5F * x / std::sqrt(1 + x * x);
    }
    return result;
}

SampledSpectrum SigmoidTable::unbounded(const Vec3& rgb, const Wavelengths& wavelengths) const {
    const float most = std::max({rgb.x, rgb.y, rgb.z});
    if (!(most > 0)) return {};
    return albedo(rgb * (0.5F / most), wavelengths) * (2 * most);
}

}  // namespace sunfleck::engine
