// Rows of flags for CLI11: each flag is read by a function of its text, into its place.
#pragma once

#include "flags/render_flags.h"
#include "flags/scene_flags.h"
#include "sunfleck/error.h"

#include <CLI/CLI.hpp>

#include <string>

namespace sunfleck::engine {

/// The names of a table's rows as a form: "bash|zsh|fish".
template <class Rows>
std::string form_of_names(const Rows& rows, const char* between = "|") {
    std::string form;
    for (const auto& row : rows) form += (form.empty() ? "" : between) + std::string(row.name);
    return form;
}

/// A flag of renders, which `flags` takes. Any command may have it.
inline void add_flag(CLI::App& app, const RenderFlag& row, RenderFlags& flags) {
    const std::string names = row.name + (row.alias.empty() ? "" : "," + row.alias);
    const auto take = [&](const CLI::results_t& texts) {
        for (const std::string& text : texts) flags.set(row.name, text);
        return true;
    };
    CLI::Option* const option = app.add_option(names, take, help_text(row));
    option->type_name(row.value.form)->group(row.group);
    option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);  // set() refuses a second one
    if (row.value.is_list)
        option->type_name(form_of_names(row.value.choices, ","))->option_text(row.value.form);
    if (row.value.repeats)
        option->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args(false);
}

/// The flags of a scene, for a command that reads one.
inline void add_request_flags(CLI::App& app, SceneRequest& request) {
    for (const SceneFlag& row : scene_flags()) {
        const auto take = [&](const CLI::results_t& texts) {
            for (const std::string& text : texts) set_scene_flag(request, row, text);
            return true;
        };
        CLI::Option* const option = app.add_option(row.name, take, row.help);
        option->type_name(row.form)->group("Scene");
        option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);  // a second one is refused
        if (row.repeats)
            option->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args(false);
    }
}

/// Any other flag, or a word without one.
struct OptionRow {
    std::string name;  // "--every", "SCENE"
    std::string form;  // of its value
    std::string help;
    std::string group = "Options";
};

/// @param read  text and name of the flag, into a value; throws Error for a text that cannot be
///        used.
template <class Place, class Read>
CLI::Option* add_value(CLI::App& app, const OptionRow& row, Place& place, Read read) {
    const auto take = [&place, read, name = row.name](const CLI::results_t& texts) {
        place = static_cast<Place>(read(texts.front(), name));
        return true;
    };
    return app.add_option(row.name, take, row.help)->type_name(row.form)->group(row.group);
}

/// The same of several values: of a flag that may be repeated, or of words without a flag.
template <class Value, class Read>
CLI::Option* add_values(CLI::App& app, const OptionRow& row, std::vector<Value>& places,
                        Read read) {
    const auto take = [&places, read, name = row.name](const CLI::results_t& texts) {
        for (const std::string& text : texts) places.push_back(read(text, name));
        return true;
    };
    return app.add_option(row.name, take, row.help)
        ->type_name(row.form)
        ->group(row.group)
        ->expected(1, CLI::detail::expected_max_vector_size)
        ->allow_extra_args(row.name.front() != '-');
}

/// A file or a folder that must have a name.
inline std::string read_name(const std::string& text, const std::string& flag) {
    if (text.empty()) throw Error({flag}, "the file has no name", "name one");
    return text;
}

}  // namespace sunfleck::engine
