// Smooth reflectances of many colours, fast: fitted coefficients on a grid of colours, linear
// between.
//
// In:  linear sRGB in [0,1]. Out: the reflectance at a pass's wavelengths.
// Source: Jakob and Hanika, A Low-Dimensional Function Space for Efficient Spectral Upsampling
// (Eurographics 2019), section 4: grids over the largest component and the two others' shares of
// it.
#pragma once

#include "math/sampled_spectrum.h"
#include "math/vector.h"
#include "math/wavelengths.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

class SigmoidTable {
public:
    /// The table of sRGB, built when first asked for: ask before, not within, parallel work.
    static const SigmoidTable& srgb();

    /// @param resolution  nodes along each of the three axes, at least 2.
    explicit SigmoidTable(std::size_t resolution);

    /// The reflectance that looks like rgb under D65; a grey exactly, other colours within the
    /// table's error (docs/develop/decisions.md). @param rgb  brought into [0,1].
    SampledSpectrum albedo(const Vec3& rgb, const Wavelengths& wavelengths) const;
    /// Any non-negative colour: twice its largest component times the albedo of the rest.
    SampledSpectrum unbounded(const Vec3& rgb, const Wavelengths& wavelengths) const;

    /// Coefficients of 1, t and t^2 (math/sigmoid_fit.h) of a colour in [0,1] that is no grey.
    std::array<float, 3> coefficients(const Vec3& rgb) const;

private:
    std::array<float, 3>& node(std::size_t largest, std::size_t z, std::size_t y, std::size_t x) {
        return nodes_[((largest * resolution_ + z) * resolution_ + y) * resolution_ + x];
    }
    void fit_column(std::size_t column);

    std::size_t resolution_;
    std::vector<float> levels_;  // of the largest component
    std::vector<float> shares_;  // that the others have of it
    std::vector<std::array<float, 3>> nodes_;
};

}  // namespace sunfleck::engine
