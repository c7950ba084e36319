// Completion by zsh.
#include "apps/cli/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sunfleck::engine {
namespace {

/// Within single quotes and within [ ] or between colons of _arguments.
std::string zsh_text(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '\'') {
            safe += "'\\''";
            continue;
        }
        if (c == '[' || c == ']' || c == ':' || c == '\\') safe += '\\';
        safe += c;
    }
    return safe;
}

std::string zsh_action(const CommandFlag& flag) {
    if (flag.is_list) return fmt::format("_values -s , name {}", fmt::join(flag.words, " "));
    if (!flag.words.empty()) return fmt::format("({})", fmt::join(flag.words, " "));
    if (flag.is_folder()) return "_files -/";
    return flag.is_file() ? "_files" : " ";
}

/// All names of a flag; each excludes the others, and itself unless it may be repeated.
std::string zsh_flag(const CommandFlag& flag) {
    const std::string others = flag.repeats ? "*" : fmt::format("({})", fmt::join(flag.names, " "));
    const std::string value =
        flag.form.empty() ? "" : ":" + zsh_text(flag.form) + ":" + zsh_action(flag);
    std::string text;
    for (const std::string& name : flag.names) {
        const bool may_equal = name.starts_with("--") && !flag.form.empty();  // --name=value
        text += fmt::format(" \\\n            '{}{}{}[{}]{}'", others, name, may_equal ? "=" : "",
                            zsh_text(short_help(flag.help)), value);
    }
    return text;
}

std::string zsh_arguments(const Command& command) {
    std::string text = "_arguments -S";
    for (const CommandFlag& flag : command.flags) text += zsh_flag(flag);
    for (std::size_t i = 0; i < command.words.size(); ++i) {
        const CommandFlag& word = command.words[i];
        text +=
            fmt::format(" \\\n            '{}:{}:{}'", word.repeats ? "*" : std::to_string(i + 1),
                        zsh_text(word.names.front()), zsh_action(word));
    }
    return text;
}

}  // namespace

std::string zsh_completion(const Command& program) {
    std::string commands;
    std::string cases;
    std::string flags;
    for (const CommandFlag& flag : program.flags) flags += zsh_flag(flag);
    for (const Command& command : program.commands) {
        commands +=
            fmt::format("            '{}:{}'\n", command.name, zsh_text(short_help(command.help)));
        cases += fmt::format("        {}) {} ;;\n", command.name, zsh_arguments(command));
    }
    return fmt::format(R"(#compdef {0}
# zsh completion for {0}; made by "{0} completion zsh".
_{0}() {{
    local curcontext=$curcontext state line
    local -a commands
    _arguments -C{1} \
            '1:command:->command' '*::word:->word'
    case $state in
    command)
        commands=(
{2}        )
        _describe command commands ;;
    word)
        case $line[1] in
{3}        esac ;;
    esac
}}
_{0} "$@"
)",
                       program.name, flags, commands, cases);
}

}  // namespace sunfleck::engine
