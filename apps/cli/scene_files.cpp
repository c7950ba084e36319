// Comparison with the files that are there, and their replacement.
#include "apps/cli/scene_files.h"

#include "image/atomic_file.h"
#include "image/read_file.h"
#include "sunfleck/error.h"

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
    std::error_code code;
    return fs::exists(path, code);
}

/// Files and folders that are new, removed again unless kept.
class NewFiles {
public:
    NewFiles() = default;
    NewFiles(const NewFiles&) = delete;
    NewFiles& operator=(const NewFiles&) = delete;
    NewFiles(NewFiles&&) = delete;
    NewFiles& operator=(NewFiles&&) = delete;
    ~NewFiles() {
        std::error_code code;  // a folder that is not empty stays
        for (; !paths_.empty(); paths_.pop_back()) fs::remove(paths_.back(), code);
    }

    void add(const fs::path& path) { paths_.push_back(path); }
    void keep() { paths_.clear(); }

private:
    std::vector<fs::path> paths_;
};

/// Makes a folder, and those around it. @throws Error  if it cannot be made.
void make_folder(const fs::path& folder, NewFiles& made) {
    if (folder.empty() || is_there(folder)) return;
    make_folder(folder.parent_path(), made);
    std::error_code fault;
    if (fs::create_directory(folder, fault)) made.add(folder);
    if (fault)
        throw Error({folder.string()}, "cannot make this folder: " + fault.message(),
                    "give another folder with -o");
}

}  // namespace

void write_scene_files(const fs::path& folder, const std::vector<ExportedFile>& files,
                       bool replaces) {
    if (!replaces)
        for (const ExportedFile& file : files) {
            const fs::path path = folder / file.name;
            if (is_there(path) && read_file(path.string()) != file.bytes())
                throw Error({path.string()},
                            "this file exists, and differs from the one to be written",
                            "give another name or folder with -o, or replace it with --force");
        }
    NewFiles made;
    for (const ExportedFile& file : files) {
        const fs::path path = folder / file.name;
        const bool is_new = !is_there(path);
        if (!is_new && !replaces) continue;
        make_folder(path.parent_path(), made);
        write_file(path.string(), file.bytes());
        if (is_new) made.add(path);
    }
    made.keep();
}

}  // namespace sunfleck::engine
