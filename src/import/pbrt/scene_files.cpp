// The list of files, and of missing ones.
#include "import/pbrt/scene_files.h"

#include "import/pbrt/words.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace sunfleck::engine {

SceneFiles::SceneFiles(const std::string& main_file, FileAccess access, ImportLog& log)
    : folder_(std::filesystem::path(main_file).parent_path().string()),
      access_(std::move(access)),
      log_(log) {}

void SceneFiles::note(const NamedFile& file, const SourceLocation& from) {
    constexpr std::size_t kLongestPath = 4096;
    list(file.path);
    if (file.by_slashes)
        log_.warn(from, "backslashes in a file's name are read as slashes: " +
                            in_quotes(file.path, kLongestPath));
}

NamedFile SceneFiles::read(const std::string& name, const SourceLocation& from) {
    NamedFile file = find(name, from);
    note(file, from);
    return file;
}

void SceneFiles::note_missing(const MissingFile& missing) {
    missing_.note(missing);
}

void SceneFiles::check_missing() const {
    constexpr std::size_t kMostListed = 20;
    const std::vector<MissingFile>& missing = missing_.files();
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

}  // namespace sunfleck::engine
