// Output files of render and merge: tried before the work, written whole or not at all.
#pragma once

#include "apps/cli/late_fault.h"
#include "film/film.h"

#include <string>
#include <vector>

namespace sunfleck {

/// @param others  other files that the command writes; empty names are none.
/// @throws Error if one of the files cannot be written, two are the same, or an output's ending is
/// unknown.
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& others);
/// @throws Error if two of the files are the same. Empty names are none.
void check_distinct(const std::vector<std::string>& files);

struct OutputOptions {
    double exposure = 0;       // stops, for formats of limited range alone
    bool extrapolate = false;  // pictures less their bias
};

/// Writes the film to every output: .film, or a picture. What cannot be written is no reason to
/// lose the others. @param faults  has it then. @return those that are written.
std::vector<std::string> write_outputs(const std::vector<std::string>& outputs, const Film& film,
                                       const OutputOptions& options, LateFault& faults);

}  // namespace sunfleck
