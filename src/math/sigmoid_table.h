// Table of smooth reflectances: fitted coefficients on a grid of colours, interpolated linearly.
//
// In:  linear sRGB in [0,1]. Out: the reflectance at the wavelengths of a pass.
// Source: Jakob and Hanika, A Low-Dimensional Function Space for Efficient Spectral Upsampling
// (Eurographics 2019), section 4: grids over the largest component and the ratios of the others to
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
    /// Returns the table of sRGB, which the first call builds; that call must not be within
    /// parallel work.
    static const SigmoidTable& srgb();

    /// @param resolution  nodes per axis, at least 2.
    explicit SigmoidTable(std::size_t resolution);

    /// Returns the reflectance that has the colour rgb under D65: exact for grey, within the
    /// table's error (docs/develop/decisions.md) for other colours. @param rgb  clamped to [0,1].
    SampledSpectrum albedo(const Vec3& rgb, const Wavelengths& wavelengths) const;
    /// Returns the spectrum of any non-negative colour: twice its largest component times an
    /// albedo.
    SampledSpectrum unbounded(const Vec3& rgb, const Wavelengths& wavelengths) const;

    /// Returns the coefficients of 1, t and t^2 (math/sigmoid_fit.h) of a colour in [0,1], not
    /// grey.
    std::array<float, 3> coefficients(const Vec3& rgb) const;

private:
    std::array<float, 3>& node(std::size_t largest, std::size_t z, std::size_t y, std::size_t x) {
        return nodes_[((largest * resolution_ + z) * resolution_ + y) * resolution_ + x];
    }
    void fit_column(std::size_t column);

    std::size_t resolution_;
    std::vector<float> levels_;  // nodes of the largest component
    std::vector<float> shares_;  // nodes of the other components' ratios to it
    std::vector<std::array<float, 3>> nodes_;
};

}  // namespace sunfleck::engine
