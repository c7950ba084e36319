// The commands and flags of the program as plain data, for help, man pages and completion.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace sunfleck::engine {

/// A flag, or a positional argument.
struct CommandFlag {
    std::vector<std::string>
        names;         // "-o", "--output"; of a positional argument its only name: "SCENE"
    std::string form;  // "N", "on|off"; empty for a flag that takes nothing
    std::vector<std::string> words;  // literal words that it takes, as far as they can be listed
    std::string group;               // heading
    std::string help;
    bool is_required = false;
    bool repeats = false;
    bool is_list = false;  // takes several of its words, with commas between

    bool is_file() const;    // takes the name of a file
    bool is_folder() const;  // takes the name of a folder
};

struct Command {
    std::string name;  // "sunfleck", or of a command: "render"
    std::string help;
    std::vector<CommandFlag> flags;
    std::vector<CommandFlag> words;     // positional arguments, in their order
    std::vector<std::string> examples;  // of use
    std::vector<Command> commands;      // its subcommands
};

Command command_tree(const CLI::App& app);

/// Is a form, or a part of one, to be typed as it stands? It has no capital letter then.
bool is_literal(const std::string& form);

/// The first sentence of a help text, without what is in parentheses.
std::string short_help(const std::string& help);

}  // namespace sunfleck::engine
