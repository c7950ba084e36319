// Warnings, files and matrices of a reading in progress.
#include "import/pbrt/reading.h"

namespace sunfleck {

constexpr std::size_t kMostWarnings = 500;
constexpr std::size_t kMostFiles = 100000;

void Reading::warn(const SourceLocation& where, const std::string& text) {
    const bool full = scene.warnings.entries().size() >= kMostWarnings;
    scene.warnings.add(where, full ? "further warnings are not listed" : text);
}

void Reading::warn_unused(const Statement& statement) {
    for (const Parameter* parameter : statement.unused())
        warn(parameter->where,
             "unused parameter " + parameter->title() + " of " + statement.title() + " is ignored");
}

void Reading::count_file(const std::string& path, const SourceLocation& from) {
    if (scene.files.size() >= kMostFiles)
        throw Error(from, "the scene opens more than 100000 files", "join some of them");
    scene.files.push_back(path);
}

std::string Reading::read_file(const std::string& name, const SourceLocation& from) {
    const std::string path = resolved(name, folder);
    std::string bytes = files(path, from);
    count_file(path, from);
    return bytes;
}

void Reading::check_blocks_closed(std::size_t base) const {
    if (blocks.size() <= base) return;
    const Block& block = blocks.back();
    const std::string end = block.begin.substr(0, block.begin.size() - 5) + "End";
    throw Error(block.where, block.begin + " is not closed", "add " + end);
}

const Matrix& Reading::still_matrix(const SourceLocation& where) {
    if (state.moves())
        warn(where, "motion is not simulated: things stand where they are at the start");
    return state.matrix[0];
}

}  // namespace sunfleck
