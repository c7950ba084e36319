// Filters of FLIP: contrast sensitivity of the eye, and detection of edges and points.
//
// Source: Andersson et al. 2020, sections 4.1.1 and 4.3. All filters are separable, or sums of two
// separable ones.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace sunfleck::engine::flip {

/// One number per pixel.
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

/// The 2 r + 1 weights around a pixel.
using Kernel = std::vector<float>;

/// Convolves rows with one kernel, then columns with the other; edge pixels extend beyond the
/// picture.
Plane convolve(const Plane& plane, const Kernel& across, const Kernel& down);

/// Returns the contrast sensitivity of an opponent channel as a sum of at most two Gaussians (each
/// applied to rows and columns), normalised in two dimensions.
/// @param channel  0 luminance, 1 red-green, 2 blue-yellow.
std::vector<Kernel> contrast_kernels(std::size_t channel, float pixels_per_degree);

/// Feature detectors of half the width of an edge of 0.082 degrees: a Gaussian with its first and
/// second derivative, whose positive weights sum to 1 and negative ones to -1.
struct FeatureKernels {
    Kernel gaussian;
    Kernel first;
    Kernel second;
};
FeatureKernels feature_kernels(float pixels_per_degree);

}  // namespace sunfleck::engine::flip
