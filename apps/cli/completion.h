// Scripts by which shells complete commands, flags and the words that flags take.
#pragma once

#include "apps/cli/command_tree.h"

#include <array>
#include <string_view>

namespace sunfleck::engine {

struct Shell {
    std::string_view name;
    std::string (*script)(const Command& program);
    std::string_view file;  // where a system keeps the script, below share/
};

std::string bash_completion(const Command& program);
std::string zsh_completion(const Command& program);
std::string fish_completion(const Command& program);

inline constexpr std::array<Shell, 3> kShells = {{
    {.name = "bash", .script = bash_completion, .file = "bash-completion/completions/sunfleck"},
    {.name = "zsh", .script = zsh_completion, .file = "zsh/site-functions/_sunfleck"},
    {.name = "fish", .script = fish_completion, .file = "fish/vendor_completions.d/sunfleck.fish"},
}};

}  // namespace sunfleck::engine
