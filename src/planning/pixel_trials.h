// Trial camera paths: how noisy each pixel is, and how much less so where paths are spread evenly.
//
// In:  a pass like an epoch's first. Out: variances, from views that are no part of a picture.
// Source: variance of the mean of a scrambled net over that of as many independent points: Owen,
// Scrambled net variance for integrals of smooth functions (Annals of Statistics 25(4), 1997).
#pragma once

#include "camera_paths/camera_pass.h"
#include "chains/chain_walk.h"
#include "planning/pixel_buffer.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sunfleck::engine {

inline constexpr std::size_t kTrialBlock = 16;  // pixels a side: enough of them to tell a variance

/// How the variance of a pixel's camera paths falls with their number, spread as a net.
struct VarianceDecay {
    /// What of it two paths leave, and twice as many of any number above four: 1/2 by chance, less
    /// of light that is smooth over pixel, lens and lights. The default is that of usual scenes.
    double doubling = 0.4;

    /// What of the variance 2^log2_samples paths leave.
    double left(unsigned log2_samples) const;

    /// What of it the paths of a batch leave, over what as many by chance would.
    double of_batch() const;
};

/// Of one camera path in each pixel, and in those around it, which are alike.
struct PixelTrials {
    /// Of the light that needs no photon, as each half of the trials has seen it.
    std::array<PixelValues, 2> variance;
    PixelValues rays;
    std::vector<VarianceDecay> nets;  // by block of kTrialBlock

    bool are_made() const { return !rays.empty(); }
    /// Have both halves seen any?
    bool have_noise() const;
};

/// Of no trials: nothing is known of the pixels' noise, and nets are as usual.
PixelTrials no_trials(const PixelWindow& window);

/// How much trial work there is.
struct TrialEffort {
    std::uint32_t pairs_of_nets = 1;  // of four views each; at least one, at most 60
    int cells = 2;                    // pixels a side, of which one has paths
};

PixelTrials trials_of_pixels(const CameraPass& first, const PilotName& name,
                             const TrialEffort& views);

}  // namespace sunfleck::engine
