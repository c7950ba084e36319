// Photon budget: the rule that balances camera paths and photon paths, without the measurement.
//
// In:  variance and cost of both in the blocks of a picture. Out: photon paths of a subpass,
// subpasses of a pass, and the weight of passes. The camera paths of a subpass are given, so the
// first number is the budget. The others make passes comparable with the first ones: subpasses are
// averaged until they have the error of a usual pass, and better passes get a weight, as in a mean
// of minimum variance. Both are known before the passes are rendered, and do not depend on them, so
// the mean is unbiased.
// Equations: docs/method/sampling.md, eqs. (18), (19) and (21).
#pragma once

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

/// Variances of a block of pixels in one subpass, as the objective judges them. Negative estimates
/// count as zero.
struct BlockVariance {
    double camera = 0;  // of camera paths: photons do not reduce it
    double photon = 0;  // of one photon path: n paths have 1/n of it
};

/// Work in units of about a ray.
struct SubpassCost {
    double camera = 0;  // of all camera paths of a subpass
    double photon = 0;  // of one photon path
};

struct PhotonBudget {
    std::uint32_t paths = 0;      // per subpass
    std::uint32_t subpasses = 1;  // per pass
    std::uint32_t weight = 1;     // of a pass

    friend bool operator==(const PhotonBudget&, const PhotonBudget&) = default;
};

/// Measurements of trials.
struct SubpassMeasures {
    std::vector<BlockVariance> blocks;
    SubpassCost cost;
};

/// Selects the number of paths among usual * {1/16, 1/8, 1/4, 1/2, 1, 2, 4} that minimises the
/// judged standard error of a block at equal work, as a mean over blocks, so that few noisy
/// blocks do not dominate. The error of a block after work w is sqrt((camera + photon / n) (c + n
/// p) / w). Also selects the number of subpasses, up to 16, with about the squared error of a usual
/// pass; or, if one subpass has less, the weight of a pass, up to kMostWeight.
/// @param fewest  no smaller number is selected, except `usual`; at least 2.
/// @param of_pass  error_of_subpass() of a usual pass.
/// @return one subpass of `usual` paths if there is no block, or no variance.
PhotonBudget allocated_budget(const SubpassMeasures& subpass, std::uint32_t usual, double fewest,
                              double of_pass);

/// Returns the judged standard error of one subpass, summed over blocks. @param paths  photon
/// paths.
double error_of_subpass(const SubpassMeasures& subpass, double paths);

/// Returns the objective of allocated_budget(): the judged standard error of a block times the
/// root of the work, summed over blocks. @param paths  photon paths of a subpass.
double error_of_subpasses(const SubpassMeasures& subpass, double paths);

}  // namespace sunfleck::engine
