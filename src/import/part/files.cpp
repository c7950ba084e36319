// Names of other systems as paths of this one.
#include "import/part/files.h"

#include <algorithm>
#include <filesystem>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

std::string with_slashes(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

std::string path_of(const std::string& name, const std::string& beside) {
    return (fs::path(beside).parent_path() / name).lexically_normal().string();
}

bool is_file(const std::string& path) {
    std::error_code code;
    return fs::is_regular_file(path, code);
}

/// Returns the place where a file of that name is, or where it should be.
std::string found_path(const std::string& name, const std::string& beside) {
    const std::string slashed = with_slashes(name);
    for (const std::string& candidate :
         {name, slashed, slashed.substr(slashed.rfind('/') + 1)})  // npos + 1 is 0
        if (is_file(path_of(candidate, beside))) return path_of(candidate, beside);
    return path_of(slashed, beside);
}

}  // namespace

bool PartFiles::exists(const std::string& name, const std::string& beside) {
    return is_file(path_of(name, beside)) || is_file(path_of(with_slashes(name), beside));
}

std::optional<PartFile> PartFiles::find(const std::string& name, const std::string& beside,
                                        const SourceLocation& from) {
    const std::string path = found_path(name, beside);
    try {
        PartFile file{path, read_input_file(path, from)};
        if (std::find(files_.begin(), files_.end(), path) == files_.end()) files_.push_back(path);
        return file;
    } catch (const MissingFile& missing) {
        missing_.note(missing);
        return std::nullopt;
    }
}

void PartFiles::check_missing(const std::string& mend) const {
    const std::size_t count = missing().size();
    if (count == 0) return;
    const bool is_one = count == 1;
    throw Error({files_.front()},
                (is_one ? "a file is missing: " : std::to_string(count) + " files are missing: ") +
                    missing_.line(),
                (is_one ? "put it there" : "put them there") + mend);
}

}  // namespace sunfleck::engine
