// Camera paths against photon paths: the rule, without the measuring.
//
// In:  what variance each of them leaves in the blocks of a picture, and what each costs. Out: the
// photon paths of a subpass, the subpasses of a pass, and how often passes count. The camera paths
// of a subpass are given, so the first number is the budget. The others are for a picture whose
// first passes had the usual paths: worse ones are drawn together until they are worth as much, and
// better ones count for as many as they are worth, as in a mean of least variance. Both are known
// before the passes are made, and not from them: so the mean has no bias.
#pragma once

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Of one block of pixels in one subpass, relative to the square of its brightness. An estimate
/// that is negative counts as none.
struct BlockVariance {
    double camera = 0;  // of camera paths: no number of photons takes it away
    double photon = 0;  // of one photon path: that of n paths is a share 1/n of it
};

/// Work in rays, about.
struct SubpassCost {
    double camera = 0;  // of all camera paths of a subpass
    double photon = 0;  // of one photon path
};

struct PhotonBudget {
    std::uint32_t paths = 0;      // photon paths of a subpass
    std::uint32_t subpasses = 1;  // of a pass
    std::uint32_t weight = 1;     // how often a pass counts

    friend bool operator==(const PhotonBudget&, const PhotonBudget&) = default;
};

/// What trials measured.
struct SubpassMeasures {
    std::vector<BlockVariance> blocks;
    SubpassCost cost;
};

/// The number of paths among usual * {1/16, 1/8, 1/4, 1/2, 1, 2, 4} that makes the relative
/// standard error of a block least after some work, in the mean over blocks: so that a few blocks
/// of wild light do not speak for all. A block's error after work w is sqrt((camera + photon / n)
/// (c + n p) / w). And as many subpasses, up to 16, as have about the squared error of a pass; or,
/// if one has less, how many passes, up to kMostWeight, have about its squared error.
/// @param fewest  no number below it is taken, unless it is `usual`; at least 2.
/// @param of_pass  error_of_subpass() of what a pass should be worth.
/// @return one subpass of `usual` paths if there is no block, or no variance at all.
PhotonBudget allocated_budget(const SubpassMeasures& subpass, std::uint32_t usual, double fewest,
                              double of_pass);

/// The relative standard errors of the blocks, together, in one subpass.
/// @param paths  photon paths.
double error_of_subpass(const SubpassMeasures& subpass, double paths);

/// What `allocated_budget()` makes least: the relative standard error of a block times the root of
/// the work, in the sum over blocks.
/// @param paths  photon paths of a subpass.
double error_of_subpasses(const SubpassMeasures& subpass, double paths);

}  // namespace sunfleck::engine
