// Names of libraries, and materials by name.
#include "import/part/libraries.h"

#include "core/small_letters.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Returns the names of a statement: all of it if there is such a file, else divided behind each
/// .mtl that a blank follows.
std::vector<std::string> names_of_statement(const std::string& text, const std::string& path) {
    if (PartFiles::exists(text, path)) return {text};
    constexpr std::string_view kEnding = ".mtl";
    const std::string small = small_letters(text);
    std::vector<std::string> names;
    std::size_t begin = 0;
    for (std::size_t at = small.find(kEnding); at != std::string::npos;
         at = small.find(kEnding, at + 1)) {
        const std::size_t end = at + kEnding.size();
        if (end < text.size() && text[end] != ' ' && text[end] != '\t') continue;
        names.push_back(text.substr(begin, end - begin));
        begin = std::min(text.find_first_not_of(" \t", end), text.size());
    }
    if (begin < text.size()) names.push_back(text.substr(begin));
    return names;
}

}  // namespace

PartLibraries::PartLibraries(PartFiles& files, const std::vector<ObjName>& statements,
                             Warnings& warnings) {
    std::vector<std::string> read;
    for (const ObjName& statement : statements)
        for (const std::string& name : names_of_statement(statement.name, statement.where.file)) {
            if (std::find(read.begin(), read.end(), name) != read.end()) continue;
            read.push_back(name);
            const auto file = files.find(name, statement.where.file, statement.where);
            are_missing_ = are_missing_ || !file;
            if (!file) continue;
            libraries_.push_back({file->path, parse_mtl(file->bytes, file->path)});
            for (const MtlRemark& remark : libraries_.back().materials.remarks)
                warnings.add(remark.where, remark.text);
        }
}

std::optional<PartLibraries::Match> PartLibraries::find(const std::string& name) const {
    for (const PartLibrary& library : libraries_)
        for (const MtlMaterial& material : library.materials.materials)
            if (material.name == name) return Match{&material, &library};
    return std::nullopt;
}

void PartLibraries::check_missing(const PartFiles& files, const ImportSettings& settings,
                                  Warnings& warnings) const {
    const auto is_library = [](const MissingFile& file) {
        return small_letters(file.path()).ends_with(".mtl");
    };
    const bool are_all = std::all_of(files.missing().begin(), files.missing().end(), is_library);
    if (!are_all) files.check_missing("");
    if (settings.material.empty()) files.check_missing(", or name a material with --material");
    for (const MissingFile& file : files.missing())
        warnings.add(file.where(), "the library of materials " + file.line() + " is missing");
}

}  // namespace sunfleck::engine
