// Reading the commands and flags from CLI11.
#include "apps/cli/command_tree.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace sunfleck::engine {
namespace {

std::vector<std::string> parts_of(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
    return parts;
}

std::vector<std::string> literal_words(const std::string& form, char separator) {
    std::vector<std::string> words;
    for (const std::string& part : parts_of(form, separator))
        if (is_literal(part)) words.push_back(part);
    return words;
}

CommandFlag flag_of(const CLI::Option& option) {
    CommandFlag flag;
    for (const std::string& name : option.get_snames()) flag.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) flag.names.push_back("--" + name);
    if (flag.names.empty()) flag.names.push_back(option.get_name());
    if (option.get_items_expected_max() > 0) {
        const std::string& text = option.get_option_text();
        flag.is_list = text.ends_with(",...");
        flag.words = literal_words(option.get_type_name(), flag.is_list ? ',' : '|');
        flag.form = text.empty() ? option.get_type_name() : text;
        flag.repeats = option.get_items_expected_max() > 1;
    }
    flag.group = option.get_group();
    flag.help = option.get_description();
    flag.is_required = option.get_required();
    return flag;
}

}  // namespace

bool is_literal(const std::string& form) {
    return std::none_of(form.begin(), form.end(),
                        [](unsigned char c) { return std::isupper(c) != 0; });
}

bool CommandFlag::is_file() const {
    return form.ends_with("FILE");
}

bool CommandFlag::is_folder() const {
    return form == "FOLDER";
}

Command command_tree(const CLI::App& app) {
    Command command{.name = app.get_name(),
                    .help = app.get_description(),
                    .flags = {},
                    .words = {},
                    .examples = {},
                    .commands = {}};
    for (const std::string& line : parts_of(app.get_footer(), '\n'))
        if (line.starts_with("  ")) command.examples.push_back(line.substr(2));
    for (const CLI::Option* option : app.get_options())
        (option->get_positional() ? command.words : command.flags).push_back(flag_of(*option));
    for (const CLI::App* below : app.get_subcommands({}))
        command.commands.push_back(command_tree(*below));
    return command;
}

std::string short_help(const std::string& help) {
    std::string text = help.substr(0, std::min(help.find(". "), help.find(" (")));
    return text.substr(0, text.find(": "));
}

}  // namespace sunfleck::engine
