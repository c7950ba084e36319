// Snapshots: picture and statistics of a render under way, a pair of files each.
#pragma once

#include "stats/stats.h"

#include <string>

namespace sunfleck::engine {

/// Returns the file by which a render claims the folder of its snapshots.
std::string claim_of_snapshots(const std::string& folder);

/// Creates the folder if it does not exist.
/// @param resumed  whether the contents of the folder are of this render.
/// @throws Error if that cannot be, or the folder holds an .exr: two renders must not mix.
void prepare_snapshots(const std::string& folder, bool resumed);

/// Whether a file of this name may be one of those below.
bool is_snapshot(const std::string& name);

/// Writes passes-NNNNNN.exr and .json, each whole or not at all, the picture last.
void write_snapshot(const std::string& folder, const Film& film, const RunFacts& facts);

}  // namespace sunfleck::engine
