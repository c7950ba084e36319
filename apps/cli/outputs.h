// Output files of render and merge: tried before the work, written whole or not at all.
#pragma once

#include "film/film.h"

#include <string>
#include <vector>

namespace sunfleck {

/// @throws Error if one of the files cannot be written, or its ending is unknown.
void check_outputs(const std::vector<std::string>& outputs, const std::string& stats);

struct OutputOptions {
    double exposure = 0;       // stops, for formats of limited range alone
    bool extrapolate = false;  // pictures less their bias
};

/// Writes the film to every output: .film, or a picture.
void write_outputs(const std::vector<std::string>& outputs, const Film& film,
                   const OutputOptions& options);

}  // namespace sunfleck
