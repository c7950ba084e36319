// Completion by bash, without the package bash-completion.
#include "apps/cli/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sunfleck::engine {
namespace {

/// What follows a flag of this kind, or stands at a word of this kind.
std::string bash_action(const CommandFlag& flag) {
    if (flag.is_list)  // completes the name behind the last comma
        return fmt::format(
            "[[ $cur == *,* ]] && before=${{cur%,*}},; "
            "COMPREPLY=($(compgen -P \"$before\" -W \"{}\" -- \"${{cur##*,}}\"))",
            fmt::join(flag.words, " "));
    if (!flag.words.empty())
        return fmt::format("COMPREPLY=($(compgen -W \"{}\" -- \"$cur\"))",
                           fmt::join(flag.words, " "));
    if (flag.is_folder()) return "compopt -o dirnames +o default 2>/dev/null";
    if (flag.is_file()) return ":";  // no reply: readline completes the names of files
    return "compopt +o default 2>/dev/null";
}

std::string bash_cases(const Command& command) {
    std::string text;
    for (const CommandFlag& flag : command.flags) {
        if (flag.form.empty()) continue;
        std::vector<std::string> patterns;
        for (const std::string& name : flag.names) patterns.push_back(command.name + ":" + name);
        text +=
            fmt::format("        {}) {}; return ;;\n", fmt::join(patterns, "|"), bash_action(flag));
    }
    return text;
}

std::string bash_flags(const Command& command) {
    std::vector<std::string> names;
    for (const CommandFlag& flag : command.flags)
        names.insert(names.end(), flag.names.begin(), flag.names.end());
    return fmt::format("{}", fmt::join(names, " "));
}

}  // namespace

std::string bash_completion(const Command& program) {
    std::string cases = bash_cases(program);
    std::string flags;
    std::vector<std::string> names;
    std::string words;
    for (const Command& command : program.commands) {
        cases += bash_cases(command);
        names.push_back(command.name);
        flags += fmt::format("        {}) flags=\"{}\" ;;\n", command.name, bash_flags(command));
        if (!command.words.empty())
            words +=
                fmt::format("        {}) {} ;;\n", command.name, bash_action(command.words.back()));
    }
    return fmt::format(R"(# bash completion for {0}; made by "{0} completion bash".
_{0}() {{
    local cur=${{COMP_WORDS[COMP_CWORD]}}
    local prev=${{COMP_WORDS[COMP_CWORD-1]}} command= before= flags word
    # The words of --flag=value are three.
    if [[ $cur == "=" ]]; then
        cur=
    elif [[ $prev == "=" ]]; then
        prev=${{COMP_WORDS[COMP_CWORD-2]}}
    fi
    for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
        case $word in {1}) command=$word; break ;; esac
    done
    COMPREPLY=()
    case ${{command:-{0}}}:$prev in
{2}    esac
    case $command in
        "")
            flags="{4}"
            [[ $cur == -* ]] || COMPREPLY=($(compgen -W "{3}" -- "$cur")) ;;
{5}    esac
    if [[ $cur == -* ]]; then
        COMPREPLY=($(compgen -W "$flags" -- "$cur"))
        return
    fi
    case $command in
{6}    esac
}}
complete -o default -F _{0} {0}
)",
                       program.name, fmt::join(names, "|"), cases, fmt::join(names, " "),
                       bash_flags(program), flags, words);
}

}  // namespace sunfleck::engine
