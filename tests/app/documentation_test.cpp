// Pages that list what the program offers list all of it.
#include "aovs/channels.h"
#include "app/program.h"

#include <regex>

namespace sunfleck::engine {
namespace {

using testing_support::ProgramTest;
using testing_support::read_text;

std::string page(const std::string& name) {
    return read_text(std::string(SUNFLECK_SOURCE_DIR) + "/" + name);
}

class Documentation : public ProgramTest {};

TEST_F(Documentation, has_each_flag_of_each_command) {
    const std::regex flag("--[a-z][a-z-]+");
    for (const auto& [command, name] :
         {std::pair("render", "docs/reference/render.md"),
          std::pair("experiment", "docs/guide/experiments.md"),
          std::pair("compare", "docs/guide/compare.md"),
          std::pair("relight", "docs/guide/relighting.md"),
          std::pair("view", "docs/guide/watch.md"), std::pair("merge", "docs/reference/render.md"),
          std::pair("convert", "docs/reference/convert.md"),
          std::pair("info", "docs/reference/render.md"), std::pair("scene", "scenes/README.md")}) {
        const std::string text = page(name);
        const std::string help = run({command, "--help"}).out;
        int flags = 0;
        for (std::sregex_iterator it(help.begin(), help.end(), flag), end; it != end; ++it) {
            const std::string word = it->str();
            if (word == "--help" || word == "--output") continue;  // -o
            ++flags;
            EXPECT_TRUE(std::regex_search(text, std::regex(word + "[^a-z-]")))
                << word << " in " << name;
        }
        EXPECT_GT(flags, 0) << help;
    }
}

TEST_F(Documentation, has_each_command) {
    const std::string text = page("docs/reference/command_line.md");
    const std::string help = run({"--help"}).out;
    const std::regex row("^  ([a-z]+) ");
    int commands = 0;
    std::istringstream lines(help.substr(help.find("Commands:")));
    for (std::string line; std::getline(lines, line);)
        if (std::smatch match; std::regex_search(line, match, row)) {
            EXPECT_NE(text.find("| `sunfleck " + match[1].str() + "` |"), std::string::npos)
                << line;
            ++commands;
        }
    EXPECT_GE(commands, 9);
}

TEST_F(Documentation, has_each_layer) {
    const std::string text = page("docs/reference/render.md");
    for (const AovRow& row : kAovs) {
        if (row.name.empty()) continue;
        EXPECT_NE(text.find("| `" + std::string(row.name) + "."), std::string::npos) << row.name;
        EXPECT_NE(text.find("`--aovs " + std::string(row.name) + "`"), std::string::npos);
    }
}

}  // namespace
}  // namespace sunfleck::engine
