// Snapshots: picture and statistics of a render under way, a pair of files each.
#pragma once

#include "apps/cli/stats.h"

#include <string>

namespace sunfleck {

/// Makes the folder where there is none.
/// @param resumed  what the folder holds is of this render.
/// @throws Error if that cannot be, or the folder holds an .exr: two renders must not mix.
void prepare_snapshots(const std::string& folder, bool resumed);

/// Writes passes-NNNNNN.exr and .json, each whole or not at all, the picture last.
void write_snapshot(const std::string& folder, const Film& film, const RunFacts& facts);

}  // namespace sunfleck
