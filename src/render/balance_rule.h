// Camera paths against photon paths: the rule, without the measuring.
//
// In:  what variance each of them leaves in the blocks of a picture, and what each costs. Out: the
// photon paths of a pass. A pass has one camera path a pixel, so their number is the balance.
#pragma once

#include <cstdint>
#include <span>

namespace sunfleck {

/// Of one block of pixels in one pass, relative to the square of its brightness. An estimate that
/// is negative counts as none.
struct BlockVariance {
    double eye = 0;     // of camera paths: no number of photons takes it away
    double photon = 0;  // of one photon path: that of n paths is a share 1/n of it
};

/// Work in rays, about.
struct PassCost {
    double eye = 0;     // of all camera paths of a pass
    double photon = 0;  // of one photon path
};

/// The number among usual * {1/16, 1/8, 1/4, 1/2, 1, 2, 4} that makes the relative standard error
/// of a block least after some work, in the mean over blocks: so that a few blocks of wild light do
/// not speak for all. A block's error after work w is sqrt((eye + photon / n) (c + n p) / w), to
/// which passes that were rendered before with the usual number add their variance and work: in the
/// picture each pass weighs the same, and many cheap ones would undo what a few good ones have
/// brought.
/// @param fewest  no number below it is taken, unless it is `usual`; at least 2.
/// @param before  passes rendered before, over those to come.
/// @return `usual` if there is no block, or no variance at all.
std::uint32_t balanced_paths(std::span<const BlockVariance> blocks, const PassCost& cost,
                             std::uint32_t usual, double fewest = 2, double before = 0);

}  // namespace sunfleck
