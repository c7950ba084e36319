// Pixel trials: trial camera paths that measure the noise of pixels and its decay with stratified
// samples.
//
// In:  a pass like an epoch's first. Out: variances, from trials that are no part of a picture.
// Source: variance of a scrambled net relative to independent points: Owen, Scrambled net variance
// for integrals of smooth functions (Annals of Statistics 25(4), 1997).
// Equations: docs/method/sampling.md, eq. (18).
#pragma once

#include "camera_paths/camera_pass.h"
#include "chains/chain_walk.h"
#include "planning/pixel_buffer.h"
#include "planning/pixel_tuning.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

inline constexpr std::size_t kTrialBlock = 16;  // side in pixels, enough to estimate a variance

/// How the variance of a pixel decays with the number of its camera paths, sampled by a net.
struct VarianceDecay {
    /// Fraction of the variance that remains when the number of samples doubles from one to two,
    /// and from any number above four: 1/2 for independent samples, less for smooth integrands
    /// under a scrambled net. The default is typical.
    double doubling = 0.4;

    /// Returns the fraction of the variance that 2^log2_samples paths leave.
    double left(unsigned log2_samples) const;

    /// Returns the variance of a batch's paths over that of as many independent paths.
    double of_batch() const;
};

/// Noise of one camera path per pixel, smoothed over similar neighbours.
struct PixelTrials {
    /// Variance of light that needs no photon, from each half of the trials.
    std::array<PixelValues, 2> variance;
    PixelValues rays;
    std::vector<VarianceDecay> nets;  // by block of kTrialBlock

    bool are_made() const { return !rays.empty(); }
    /// Returns whether both halves have noise.
    bool have_noise() const;
};

/// Returns the result of no trials: unknown noise, and the decay that is assumed.
PixelTrials no_trials(const PixelWindow& window, const VarianceDecay& net = {});

/// The amount of trial work.
struct TrialEffort {
    std::uint32_t pairs_of_nets = 1;  // of four trials each; at least one, at most 60
    int cells = kCellsOfPixelTrials;  // one path per cells x cells pixels
};

PixelTrials trials_of_pixels(const CameraPass& first, const PilotName& name,
                             const TrialEffort& effort);

}  // namespace sunfleck::engine
