// Writing man pages and completion files.
#include "apps/cli/manual.h"

#include "apps/cli/completion.h"
#include "apps/cli/man_pages.h"
#include "image/atomic_file.h"
#include "sunfleck/error.h"

#include <filesystem>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

void write_below(const fs::path& folder, const fs::path& name, const std::string& text) {
    const fs::path file = folder / name;
    std::error_code code;
    fs::create_directories(file.parent_path(), code);
    if (code)
        throw Error({file.parent_path()}, "the folder cannot be made: " + code.message(),
                    "give another folder");
    write_file(file.string(), text);
}

}  // namespace

void write_manual(const Command& program, const std::string& folder) {
    if (folder.empty()) throw Error({"FOLDER"}, "its name is empty", "write . for this folder");
    const fs::path pages = fs::path(folder) / "man/man1";
    write_below(pages, program.name + ".1", man_page(program));
    for (const Command& command : program.commands)
        write_below(pages, program.name + "-" + command.name + ".1", man_page(program, command));
    for (const Shell& shell : kShells) write_below(folder, shell.file, shell.script(program));
}

}  // namespace sunfleck::engine
