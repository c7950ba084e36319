// Warnings, files and matrices of a reading in progress.
#include "import/pbrt/reading.h"

#include "import/pbrt/transforms.h"
#include "import/pbrt/words.h"

#include <algorithm>

namespace sunfleck {

constexpr std::size_t kMostWarnings = 500;
constexpr std::size_t kMostListed = 20;  // of missing files
constexpr std::size_t kLongestPath = 4096;

void Reading::count_word(std::string_view directive, std::string_view word) {
    ++words[{std::string(directive), std::string(word)}];
}

void Reading::warn(const SourceLocation& where, const std::string& text) {
    const bool full = scene.warnings.entries().size() >= kMostWarnings;
    scene.warnings.add(where, full ? "further warnings are not listed" : text);
}

void Reading::warn_unused(const Statement& statement) {
    for (const Parameter* parameter : statement.unused())
        warn(parameter->where,
             "unused parameter " + parameter->title() + " of " + statement.title() + " is ignored");
}

void Reading::warn_unused_defaults() {
    for (const auto& parameter : defaults)
        if (!parameter->used)
            warn(parameter->where, "no statement after it uses the parameter " +
                                       parameter->title() + " of Attribute: it is ignored");
}

void Reading::note_file(const NamedFile& file, const SourceLocation& from) {
    if (files_read.insert(file.path).second) scene.files.push_back(file.path);
    if (file.by_slashes)
        warn(from, "backslashes in a file's name are read as slashes: " +
                       in_quotes(file.path, kLongestPath));
}

NamedFile Reading::read_file(const std::string& name, const SourceLocation& from) {
    NamedFile file = find_file(name, folder, from, files);
    note_file(file, from);
    return file;
}

void Reading::note_missing(const MissingFile& fault) {
    const bool known = std::any_of(missing.begin(), missing.end(), [&](const MissingFile& other) {
        return other.path() == fault.path();
    });
    if (!known) missing.push_back(fault);
}

void Reading::check_missing() const {
    if (missing.empty()) return;
    if (missing.size() == 1) throw MissingFile(missing[0]);
    std::string list;
    for (std::size_t i = 0; i < std::min(missing.size(), kMostListed); ++i)
        list += "\n  " + missing[i].line();
    if (missing.size() > kMostListed)
        list += "\n  and " + std::to_string(missing.size() - kMostListed) + " more";
    throw Error(missing[0].where(), std::to_string(missing.size()) + " files are missing",
                "check their names:" + list);
}

void Reading::check_blocks_closed(std::size_t base) const {
    if (blocks.size() <= base) return;
    const Block& block = blocks.back();
    const std::string end = block.begin.substr(0, block.begin.size() - 5) + "End";
    throw Error(block.where, block.begin + " is not closed", "add " + end);
}

Matrix Reading::still_matrix(const SourceLocation& where) {
    return still(state.matrix, where);
}

Matrix Reading::still(const Motion& motion, const SourceLocation& where) {
    if (motion[0] == motion[1]) return motion[0];
    warn(where,
         "motion is not simulated: things stand where they are in the middle of the exposure");
    const double open = options.camera ? options.camera->real("shutteropen", 0) : 0;
    const double close = options.camera ? options.camera->real("shutterclose", 1) : 1;
    const double span = transform_times[1] - transform_times[0];
    const double elapsed = 0.5 * (open + close) - transform_times[0];
    const double share = span > 0 ? std::clamp(elapsed / span, 0.0, 1.0) : elapsed > 0 ? 1 : 0;
    return between(motion[0], motion[1], share);
}

}  // namespace sunfleck
