// PartFiles: the files that a part names: libraries of materials, and their pictures.
#pragma once

#include "core/missing_files.h"

#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A file that was found.
struct PartFile {
    std::string path;
    std::string bytes;
};

class PartFiles {
public:
    /// @param path  of the part, which is read already.
    explicit PartFiles(const std::string& path) : files_{path} {}

    /// Finds a file by the name that another has for it. Backslashes count as slashes; where a
    /// folder of another machine does not exist, the name alone is looked for beside the file.
    /// @param beside  path of the file that names it.
    /// @return nothing if it is missing, of which check_missing() tells.
    std::optional<PartFile> find(const std::string& name, const std::string& beside,
                                 const SourceLocation& from);
    /// Returns whether there is a file of exactly that name.
    static bool exists(const std::string& name, const std::string& beside);

    /// @param mend  what else would help. @throws Error  that names all files that are missing.
    void check_missing(const std::string& mend) const;
    const std::vector<MissingFile>& missing() const { return missing_.files(); }

    /// Returns the paths of all files that were read, each once.
    const std::vector<std::string>& files() const { return files_; }

private:
    std::vector<std::string> files_;
    MissingFiles missing_;
};

}  // namespace sunfleck::engine
