// The wavelengths of a pass, shared by camera and photon paths, and what a wavelength is worth in
// RGB.
//
// Source: design note "Spectra, batches, pixel values" (docs/method/method.md); density near the
// eye's response as in pbrt-v4 (Radziszewski et al. 2009, "An improved technique for full spectral
// rendering").
#pragma once

#include "core/random.h"
#include "math/colour_matrix.h"
#include "math/sampled_spectrum.h"
#include "math/vector.h"

namespace sunfleck::engine {

/// Consecutive passes whose wavelengths tile one lattice: the unit of error bars.
inline constexpr std::uint32_t kBatchPasses = 16;

struct Wavelengths {
    std::array<float, kWavelengths> nm{};       // in [360, 830]
    std::array<float, kWavelengths> density{};  // per nm, with which each wavelength was drawn

    /// The wavelengths of one pass. Over the kBatchPasses passes of a batch the kWavelengths x
    /// kBatchPasses fractions are one lattice, shifted at random (one shift a batch). So are those
    /// of its first 2, 4, 8 passes, coarser; and every pass is unbiased by itself.
    static Wavelengths of_pass(PassId pass);

    /// Turns what to_rgb() gives by a matrix on linear sRGB, given by its rows.
    void transform_rgb(const Rows& rows);

    /// Linear sRGB of a radiance spectrum, in pbrt-v4's scale: the D65 illuminant scaled to
    /// luminance one gives (1,1,1) in expectation.
    Vec3 to_rgb(const SampledSpectrum& radiance) const {
        return {(rgb_weight[0] * radiance).sum(), (rgb_weight[1] * radiance).sum(),
                (rgb_weight[2] * radiance).sum()};
    }

    /// For r, g, b: the sum over wavelengths of weight[wavelength] * radiance[wavelength]; what
    /// to_rgb() uses.
    std::array<SampledSpectrum, 3> rgb_weight{};
};

}  // namespace sunfleck::engine
