// Groups of a batch's passes whose wavelengths are spread evenly: what of an open batch counts.
//
// The wavelengths of a batch are one lattice (math/wavelengths.h). Those of its first 1, 2, 4 and 8
// passes are coarser ones, and so are those of passes 1, 2-3, 4-7, 8-11 and 12-15 by themselves;
// the first 12 are three quarters of a fine one. Any other passes leave gaps.
#pragma once

#include "film/pass_set.h"

namespace sunfleck::engine {

/// The group in which a pass of an open batch is summed: all passes before the first of 1, 2, 4, 8
/// or 12 up to which some are missing; after these, the passes between two of these numbers.
/// It follows from the set of passes, and passes of one group stay in one while the set grows.
/// @param passes  that there are. @return the whole batch if that is complete.
PassRange group_of(const PassSet& passes, std::uint64_t pass);

/// Groups of open batches that hold passes, ascending.
std::vector<PassRange> open_groups(const PassSet& passes);

/// How often the passes of a group count beside those of complete batches: once from 8 on, less by
/// the square of their number if they are fewer, not at all while some are missing.
double share_of_group(const PassSet& passes, const PassRange& group);

}  // namespace sunfleck::engine
