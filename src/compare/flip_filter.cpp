// Separable convolution, and the kernels of FLIP.
#include "compare/flip_filter.h"

#include "core/parallel.h"
#include "math/vector.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine::flip {
namespace {

constexpr std::size_t kRowsOfTask = 16;
constexpr float kFeatureWidth = 0.082F;  // degrees

/// a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees: table 1 of the paper.
struct Gaussian {
    float a;
    float b;
};
constexpr std::array<std::array<Gaussian, 2>, 3> kContrast = {{
    {{{1, 0.0047F}, {0, 1e-5F}}},
    {{{1, 0.0053F}, {0, 1e-5F}}},
    {{{34.1F, 0.04F}, {13.5F, 0.025F}}},
}};
constexpr float kWidest = 0.04F;

int radius_of(const Kernel& kernel) {
    return static_cast<int>(kernel.size() / 2);
}

float sum(const Kernel& kernel) {
    float all = 0;
    for (const float weight : kernel) all += weight;
    return all;
}

void for_rows(int height, const std::function<void(int)>& task) {
    parallel_blocks(static_cast<std::size_t>(height), kRowsOfTask,
                    [&](std::size_t begin, std::size_t end) {
                        for (std::size_t y = begin; y < end; ++y) task(static_cast<int>(y));
                    });
}

/// The positive weights shall sum to 1, and the negative ones to -1.
void balance(Kernel& kernel) {
    float positive = 0;
    float negative = 0;
    for (const float weight : kernel) (weight > 0 ? positive : negative) += weight;
    for (float& weight : kernel) weight /= weight > 0 ? positive : -negative;
}

Plane convolve_across(const Plane& plane, const Kernel& kernel) {
    const int radius = radius_of(kernel);
    Plane out{plane.width, plane.height, std::vector<float>(plane.values.size())};
    for_rows(plane.height, [&](int y) {
        const float* const row = plane.row(y);
        const auto width = static_cast<std::size_t>(plane.width);
        std::vector<float> padded(width + kernel.size() - 1);
        for (std::size_t i = 0; i < padded.size(); ++i)
            padded[i] = row[std::clamp(static_cast<int>(i) - radius, 0, plane.width - 1)];
        float* const to = out.row(y);
        for (std::size_t k = 0; k < kernel.size(); ++k)
            for (std::size_t x = 0; x < width; ++x) to[x] += kernel[k] * padded[x + k];
    });
    return out;
}

Plane convolve_down(const Plane& plane, const Kernel& kernel) {
    const int radius = radius_of(kernel);
    Plane out{plane.width, plane.height, std::vector<float>(plane.values.size())};
    for_rows(plane.height, [&](int y) {
        float* const to = out.row(y);
        for (int k = -radius; k <= radius; ++k) {
            const float* const row = plane.row(std::clamp(y + k, 0, plane.height - 1));
            const float weight = kernel[static_cast<std::size_t>(k + radius)];
            for (int x = 0; x < plane.width; ++x) to[x] += weight * row[x];
        }
    });
    return out;
}

}  // namespace

Plane convolve(const Plane& plane, const Kernel& across, const Kernel& down) {
    return convolve_down(convolve_across(plane, across), down);
}

std::vector<Kernel> contrast_kernels(std::size_t channel, float pixels_per_degree) {
    // Three standard deviations of the widest Gaussian of all channels.
    const int radius =
        static_cast<int>(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * pixels_per_degree));
    std::vector<Kernel> kernels;
    float volume = 0;
    for (const Gaussian& g : kContrast.at(channel)) {
        if (g.a == 0) continue;
        const float height = std::sqrt(g.a * std::sqrt(kPi / g.b));  // its square in the product
        Kernel& kernel = kernels.emplace_back();
        for (int i = -radius; i <= radius; ++i) {
            const float x = static_cast<float>(i) / pixels_per_degree;
            kernel.push_back(height * std::exp(-kPi * kPi * x * x / g.b));
        }
        volume += sum(kernel) * sum(kernel);
    }
    for (Kernel& kernel : kernels)
        for (float& weight : kernel) weight /= std::sqrt(volume);
    return kernels;
}

FeatureKernels feature_kernels(float pixels_per_degree) {
    const float deviation = 0.5F * kFeatureWidth * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    FeatureKernels kernels;
    for (int i = -radius; i <= radius; ++i) {
        const float x = static_cast<float>(i) / deviation;
        const float g = std::exp(-x * x / 2);
        kernels.gaussian.push_back(g);
        kernels.first.push_back(-x * g);
        kernels.second.push_back((x * x - 1) * g);
    }
    const float all = sum(kernels.gaussian);
    for (float& weight : kernels.gaussian) weight /= all;
    balance(kernels.first);
    balance(kernels.second);
    return kernels;
}

}  // namespace sunfleck::engine::flip
