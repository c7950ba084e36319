// SceneFiles: finds, reads and lists the files of a scene, and collects missing ones for one common
// error.
#pragma once

#include "core/missing_files.h"
#include "import/pbrt/file_access.h"
#include "import/pbrt/import_log.h"

#include <set>
#include <string>
#include <vector>

namespace sunfleck::engine {

class SceneFiles {
public:
    /// @param main_file  relative names start at its folder; it is not listed.
    /// @param log  receives warnings of backslashes that are read as slashes; it must outlive this.
    SceneFiles(const std::string& main_file, FileAccess access, ImportLog& log);

    /// Returns the path of a name in the scene.
    std::string path_of(const std::string& name) const { return resolved(name, folder_); }
    /// Finds and reads a file without listing it. Thread-safe.
    /// @throws MissingFile, Error  as find_file().
    NamedFile find(const std::string& name, const SourceLocation& from) const {
        return find_file(name, folder_, from, access_);
    }
    /// Makes a copy that warns in another log.
    SceneFiles(const SceneFiles& other, ImportLog& log)
        : folder_(other.folder_),
          access_(other.access_),
          log_(log),
          paths_(other.paths_),
          known_paths_(other.known_paths_),
          missing_(other.missing_) {}

    /// Adds a file that was read to the list.
    void list(const std::string& path) {
        if (known_paths_.insert(path).second) paths_.push_back(path);
    }
    /// Adds a file to the list, and warns if its backslashes were read as slashes.
    void note(const NamedFile& file, const SourceLocation& from);
    /// Finds and reads a file, and lists it. @throws MissingFile, Error  as find().
    NamedFile read(const std::string& name, const SourceLocation& from);
    /// Reads and parses a data file.
    /// @param parse  takes a NamedFile; Errors that it throws get the location of the statement.
    /// @return what `parse` returns.
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

    /// Returns the paths of all files that were read, each once, in order of first reading.
    const std::vector<std::string>& paths() const { return paths_; }

private:
    std::string folder_;
    FileAccess access_;
    ImportLog& log_;
    std::vector<std::string> paths_;
    std::set<std::string> known_paths_;
    MissingFiles missing_;
};

}  // namespace sunfleck::engine
