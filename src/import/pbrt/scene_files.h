// The files of one scene: finds and reads those that it names, lists them, and keeps the missing
// ones, so that one error can tell all of them.
#pragma once

#include "import/pbrt/file_access.h"
#include "import/pbrt/import_log.h"

#include <set>
#include <string>
#include <vector>

namespace sunfleck::engine {

class SceneFiles {
public:
    /// @param main_file  the first of the list; relative names start at its folder.
    /// @param log  is told of names whose backslashes are read as slashes; it must outlive this.
    SceneFiles(const std::string& main_file, FileAccess access, ImportLog& log);

    /// The path that a name in the scene stands for.
    std::string path_of(const std::string& name) const { return resolved(name, folder_); }
    /// Finds and reads a file, and leaves the list as it is. Any number of threads may call it at
    /// a time. @throws MissingFile, Error  as find_file() does.
    NamedFile find(const std::string& name, const SourceLocation& from) const {
        return find_file(name, folder_, from, access_);
    }
    /// Enters a file in the list, and warns if it was found by slashes for its backslashes.
    void note(const NamedFile& file, const SourceLocation& from);
    /// Finds and reads a file, and enters it in the list. @throws MissingFile, Error  as find().
    NamedFile read(const std::string& name, const SourceLocation& from);
    /// Reads a data file as something else than bytes.
    /// @param parse  takes a NamedFile. The Errors that it throws are told with the statement that
    /// asked for the file. @return what `parse` returns.
    template <class Parse>
    auto read_as(const std::string& name, const SourceLocation& from, const Parse& parse) {
        try {
            return parse(read(name, from));
        } catch (const Error& fault) {
            if (fault.where().file == from.file) throw;
            throw fault.asked_for_at(from);
        }
    }

    /// Notes a missing file; each path counts once.
    void note_missing(const MissingFile& missing);
    /// @throws Error  that lists the missing files, if there are any.
    void check_missing() const;

    /// The paths of all files that were read, each once, in the order of their first reading.
    const std::vector<std::string>& paths() const { return paths_; }

private:
    std::string folder_;
    FileAccess access_;
    ImportLog& log_;
    std::vector<std::string> paths_;
    std::set<std::string> known_paths_;
    std::vector<MissingFile> missing_;
};

}  // namespace sunfleck::engine
