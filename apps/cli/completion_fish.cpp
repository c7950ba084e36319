// Completion by fish.
#include "apps/cli/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sunfleck::engine {
namespace {

/// In single quotes.
std::string fish_text(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + "'";
}

/// What a flag takes: words, files (the shell's own), or what cannot be completed.
std::string fish_value(const CommandFlag& flag) {
    if (flag.form.empty()) return " -f";
    if (flag.is_list)
        return fmt::format(" -x -a '(__fish_append , {})'", fmt::join(flag.words, " "));
    if (!flag.words.empty())
        return " -x -a " + fish_text(fmt::format("{}", fmt::join(flag.words, " ")));
    if (flag.is_folder()) return " -x -a '(__fish_complete_directories)'";
    return flag.is_file() ? " -r -F" : " -x";
}

std::string fish_flag(const CommandFlag& flag, const std::string& begin) {
    std::string line = begin;
    for (const std::string& name : flag.names)
        line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    return line + fish_value(flag) + " -d " + fish_text(short_help(flag.help)) + "\n";
}

}  // namespace

std::string fish_completion(const Command& program) {
    std::string text =
        fmt::format("# fish completion for {0}; made by \"{0} completion fish\".\n", program.name);
    const std::string begin = "complete -c " + program.name;
    for (const CommandFlag& flag : program.flags)
        text += fish_flag(flag, begin + " -n __fish_use_subcommand");
    for (const Command& command : program.commands)
        text += fmt::format("{} -n __fish_use_subcommand -f -a {} -d {}\n", begin, command.name,
                            fish_text(short_help(command.help)));
    for (const Command& command : program.commands) {
        const std::string here =
            fmt::format("{} -n '__fish_seen_subcommand_from {}'", begin, command.name);
        for (const CommandFlag& flag : command.flags) text += fish_flag(flag, here);
        for (const CommandFlag& word : command.words)
            if (!word.is_file())
                text += fmt::format("{} -f -a {}\n", here,
                                    fish_text(fmt::format("{}", fmt::join(word.words, " "))));
    }
    return text;
}

}  // namespace sunfleck::engine
