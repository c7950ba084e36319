// MissingFiles: the files that a scene names and that do not exist, so that all are told at once.
#pragma once

#include "core/input_file.h"

#include <algorithm>
#include <string>
#include <vector>

namespace sunfleck::engine {

class MissingFiles {
public:
    /// Notes a file; each path counts once.
    void note(const MissingFile& file) {
        const bool is_known =
            std::any_of(files_.begin(), files_.end(),
                        [&](const MissingFile& known) { return known.path() == file.path(); });
        if (!is_known) files_.push_back(file);
    }

    const std::vector<MissingFile>& files() const { return files_; }

    /// Returns what is known of all files, on one line.
    std::string line() const {
        std::string all;
        for (const MissingFile& file : files_) all += (all.empty() ? "" : "; ") + file.line();
        return all;
    }

private:
    std::vector<MissingFile> files_;
};

}  // namespace sunfleck::engine
