// Snapshots: picture and statistics of a render under way, a pair of files each; and the newest
// picture under a name that stays.
#pragma once

#include "apps/cli/outputs.h"
#include "stats/stats.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// Returns the files by which a render claims the folder of its snapshots.
std::vector<std::string> claims_of_snapshots(const std::string& folder);

/// Creates the folder if it does not exist.
/// @param resumed  whether the contents of the folder are of this render.
/// @throws Error if that cannot be, or the folder holds an .exr or latest.png: two renders must not
/// mix. Also if latest.exr or latest.png is a link: what it leads to would be replaced.
void prepare_snapshots(const std::string& folder, bool resumed);

/// Whether a file of this name may be one of those below.
bool is_snapshot(const std::string& name);

/// Writes passes-NNNNNN.json and .exr, then replaces latest.exr and latest.png: each file whole or
/// not at all.
void write_snapshot(const std::string& folder, const Film& film, const RunFacts& facts,
                    const OutputOptions& options);

}  // namespace sunfleck::engine
