// The filters of FLIP: what an eye at normal distance resolves, and what it sees as edge or point.
//
// Source: Andersson et al. 2020, sections 4.1.1 and 4.3. All are products of a filter across and
// one down, or sums of two such.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace sunfleck::engine::flip {

/// One number a pixel.
struct Plane {
    int width = 0;
    int height = 0;
    std::vector<float> values;

    const float* row(int y) const { return values.data() + offset(y); }
    float* row(int y) { return values.data() + offset(y); }

private:
    std::size_t offset(int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    }
};

/// 2 r + 1 weights around a pixel.
using Kernel = std::vector<float>;

/// Convolves across with one kernel, then down with the other; beyond the edges the edge goes on.
Plane convolve(const Plane& plane, const Kernel& across, const Kernel& down);

/// Contrast sensitivity of one opponent channel, as a sum of at most two Gaussians (each to be
/// applied across and down). They sum to one in two dimensions.
/// @param channel  0 luminance, 1 red-green, 2 blue-yellow.
std::vector<Kernel> contrast_kernels(std::size_t channel, float pixels_per_degree);

/// Detectors of features as wide as half of an edge's 0.082 degrees: a Gaussian, and its first and
/// second derivative, each with positive weights that sum to 1 and negative ones to -1.
struct FeatureKernels {
    Kernel gaussian;
    Kernel first;
    Kernel second;
};
FeatureKernels feature_kernels(float pixels_per_degree);

}  // namespace sunfleck::engine::flip
