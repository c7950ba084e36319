// The wavelengths of a pass, shared by camera and photon paths, and what a lane is worth in RGB.
//
// Source: design note "Spectra, rounds, pixel values" (docs/method.md); density near the eye's
// response as in pbrt-v4 (Radziszewski et al. 2009, "An improved technique for full spectral
// rendering").
#pragma once

#include "core/random.h"
#include "math/colour_matrix.h"
#include "math/sampled_spectrum.h"
#include "math/vector.h"

namespace sunfleck {

/// Consecutive passes whose wavelengths tile one lattice: the unit of error bars.
inline constexpr std::uint32_t kRoundPasses = 16;

struct Wavelengths {
    std::array<float, kLanes> nm{};       // in [360, 830]
    std::array<float, kLanes> density{};  // per nm, with which each lane was drawn

    /// The wavelengths of one pass. Over the kRoundPasses passes of a round the kLanes x
    /// kRoundPasses fractions are one lattice, shifted at random (one shift a round). So are those
    /// of its first 2, 4, 8 passes, coarser; and every pass is unbiased by itself.
    static Wavelengths of_pass(PassId pass);

    /// Turns what to_rgb() gives by a matrix on linear sRGB, given by its rows.
    void turn_rgb(const Rows& rows);

    /// Linear sRGB of a radiance spectrum, in pbrt-v4's scale: the D65 illuminant scaled to
    /// luminance one gives (1,1,1) in expectation.
    Vec3 to_rgb(const Spectrum& radiance) const {
        return {(rgb_weight[0] * radiance).sum(), (rgb_weight[1] * radiance).sum(),
                (rgb_weight[2] * radiance).sum()};
    }

    /// For r, g, b: the sum over lanes of weight[lane] * radiance[lane]; what to_rgb() uses.
    std::array<Spectrum, 3> rgb_weight{};
};

}  // namespace sunfleck
