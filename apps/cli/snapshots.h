// Snapshots: picture and statistics of a render under way, a pair of files each.
#pragma once

#include "apps/cli/stats.h"

#include <string>

namespace sunfleck::engine {

/// The file of the folder that a render claims which writes snapshots to it.
std::string claim_of_snapshots(const std::string& folder);

/// Makes the folder where there is none.
/// @param resumed  what the folder holds is of this render.
/// @throws Error if that cannot be, or the folder holds an .exr: two renders must not mix.
void prepare_snapshots(const std::string& folder, bool resumed);

/// Whether a file of this name may be one of those below.
bool is_snapshot(const std::string& name);

/// Writes passes-NNNNNN.exr and .json, each whole or not at all, the picture last.
void write_snapshot(const std::string& folder, const Film& film, const RunFacts& facts);

}  // namespace sunfleck::engine
