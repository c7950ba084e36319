// Groups of passes in an open batch whose wavelengths are evenly spread, and their share in the
// picture.
//
// The wavelengths of a batch are one lattice (math/wavelengths.h). Those of its first 1, 2, 4 and 8
// passes are coarser lattices, and so are those of passes 1, 2-3, 4-7, 8-11 and 12-15; the first 12
// are three quarters of a fine one. Other sets of passes leave gaps.
// Equations: docs/method/errors.md, eq. (25).
#pragma once

#include "film/pass_set.h"

namespace sunfleck::engine {

/// Returns the group in which a pass of an open batch is summed: all passes before the first of 1,
/// 2, 4, 8 or 12 up to which some are missing; behind it, the passes between two of these numbers.
/// The group depends on the set of passes; passes of one group stay together while the set grows.
/// @param passes  the set. @return the whole batch if it is complete.
PassRange group_of(const PassSet& passes, std::uint64_t pass);

/// Returns the group of that pass where no others are joined to it: pass 0 or 1 of a batch, or
/// passes 2-3, 4-7, 8-11 or 12-15; in the first batch 4-5 and 6-7 are groups of their own.
PassRange smallest_group(std::uint64_t pass);

/// Returns the groups of open batches that contain passes, ascending.
std::vector<PassRange> open_groups(const PassSet& passes);

/// Returns the factor of a group's passes in the picture, beside passes of complete batches: one
/// from 8 passes on, smaller by the square of their number if they are fewer, zero while some are
/// missing.
double share_of_group(const PassSet& passes, const PassRange& group);

}  // namespace sunfleck::engine
