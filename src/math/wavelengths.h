// Wavelengths of a pass, shared by its camera and photon paths, and their weights in RGB.
//
// Source: docs/method/errors.md, "Spectra, batches, pixel values"; a density near the eye's
// response as in pbrt-v4 (Radziszewski et al. 2009, "An improved technique for full spectral
// rendering").
// Equations: docs/method/errors.md, eq. (24).
#pragma once

#include "core/random.h"
#include "math/colour_matrix.h"
#include "math/sampled_spectrum.h"
#include "math/vector.h"

namespace sunfleck::engine {

/// Passes of a batch: their wavelengths form one lattice. A batch is the independent unit of error
/// bars (batch means).
inline constexpr std::uint32_t kBatchPasses = 16;

struct Wavelengths {
    std::array<float, kWavelengths> nm{};       // in [360, 830]
    std::array<float, kWavelengths> density{};  // sampling density of each wavelength, per nm

    /// Returns the wavelengths of one pass. The kWavelengths x kBatchPasses fractions of a batch
    /// form one lattice with one random shift; those of its first 2, 4, 8 passes form coarser
    /// lattices. Each pass by itself is unbiased.
    static Wavelengths of_pass(PassId pass);

    /// Applies a matrix on linear sRGB, given by its rows, to the results of to_rgb().
    void transform_rgb(const Rows& rows);

    /// Returns linear sRGB of a radiance spectrum in pbrt-v4's scale: D65 of luminance one has the
    /// expected value (1,1,1).
    Vec3 to_rgb(const SampledSpectrum& radiance) const {
        return {(rgb_weight[0] * radiance).sum(), (rgb_weight[1] * radiance).sum(),
                (rgb_weight[2] * radiance).sum()};
    }

    /// Weights of to_rgb(): r, g, b are sums over wavelengths of weight[wavelength] *
    /// radiance[wavelength].
    std::array<SampledSpectrum, 3> rgb_weight{};
};

}  // namespace sunfleck::engine
