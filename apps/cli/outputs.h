// Output files of render and merge: checked before the work, written completely or not at all.
#pragma once

#include "apps/cli/deferred_error.h"
#include "film/film.h"
#include "image/atomic_file.h"
#include "image/exposure.h"
#include "image/picture_file.h"
#include "mattes/mattes.h"

#include <list>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// @param others  other files that the command writes; empty names are none.
/// @throws Error if one of the files cannot be written, or an output's ending is unknown.
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& others);

/// The files that a command reads and writes. Empty names stand for no file; the input "-" is
/// standard input.
struct CommandFiles {
    std::vector<std::string> inputs;
    std::vector<std::string> outputs;
    std::string snapshots = {};  // a folder for snapshots (snapshots.h)
};
/// @throws Error if an output is an input or another output, by whatever name, link or case.
void check_apart(const CommandFiles& files);

/// Keeps other programs from writing these files while it lives.
class OutputClaims {
public:
    /// @throws Error if another program has claimed one of them. Empty names stand for no file.
    explicit OutputClaims(const std::vector<std::string>& files);

private:
    std::list<OutputClaim> claims_;
};

struct OutputOptions {
    Exposure exposure;         // for formats of limited range alone
    bool extrapolate = false;  // pictures minus their bias
    PictureFileOptions files{};
    const Mattes* mattes = nullptr;  // to add to an .exr, if there are any
};

struct WrittenOutputs {
    std::vector<std::string> files;
    std::optional<double> found_exposure;  // stops, where a file has an automatic one
    std::string exposed_ending;            // of that file: ".png"
};

/// Writes the film to every output: as .film, or as a picture. If one fails, the others are still
/// written. @param faults  receives the failures.
WrittenOutputs write_outputs(const std::vector<std::string>& outputs, const Film& film,
                             const OutputOptions& options, DeferredError& faults);

}  // namespace sunfleck::engine
