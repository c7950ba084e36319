// A flag of a render as a row of data: its names, values, help, and the flags that it goes with.
#pragma once

#include "flags/render_request.h"
#include "flags/values.h"

#include <fmt/format.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// A word that a flag takes.
struct FlagChoice {
    std::string name;
    std::string what{};  // meaning of the word; empty where the help of the flag says it
};

/// The value of a flag: its form, its choices, and how its text changes the request.
struct FlagValue {
    std::string form;     // "N", "WxH", "on|off": a word in small letters is literal
    std::string range{};  // "1 to 10000"; empty where two numbers cannot say it
    std::vector<FlagChoice>
        choices{};         // all words that it takes; empty: any text that read() takes
    bool is_list = false;  // takes several of its choices, separated by commas
    bool repeats = false;  // may be given several times
    /// Reads a text, which has been compared with the choices where there are any.
    /// @throws Error that names the flag for a text that cannot be used.
    std::function<void(RenderRequest&, const std::string& text, const std::string& flag)> read;
};

/// A condition on another flag, without which this one has no meaning and is refused.
struct FlagNeed {
    std::string flag;  // the other flag
    /// Values of the other flag, one of which is needed. Empty: the other flag must not be given.
    std::vector<std::string> values{};
    std::string why{};                  // reason in the message; empty: made from the condition
    std::string mend = "leave it out";  // remedy in the message
    std::string of_value{};             // the condition applies to this value alone; empty: to any
};

/// The flag needs --integrator sppm, the only one with photons.
inline FlagNeed needs_photon_mapping() {
    return {.flag = "--integrator", .values = {"sppm"}};
}

/// The flag needs a photon sampler other than `paper`.
FlagNeed refused_by_paper(const std::string& why, const std::string& mend = "leave it out");

/// The same condition, for one value of the flag alone.
inline FlagNeed of_value(const std::string& value, FlagNeed need) {
    need.of_value = value;
    return need;
}

struct RenderFlag {
    std::string name;     // "--passes"
    std::string alias{};  // "--spp"; empty: none
    std::string group{};  // heading in the help: that of its table
    FlagValue value;
    std::string help;
    std::string default_value{};  // of a flag that is not given; the first choice where it is empty
    std::vector<FlagNeed> needs{};  // in addition to those of its table
};

/// Returns the complete help of a flag: its meaning, its choices, its range and its default.
std::string help_text(const RenderFlag& flag);

/// Makes a value that `read(text, flag)` parses and `set(request, value)` stores.
template <class Read, class Set>
FlagValue value_of(const std::string& form, Read read, Set set) {
    return {.form = form,
            .read = [=](RenderRequest& request, const std::string& text, const std::string& flag) {
                set(request, read(text, flag));
            }};
}

/// Makes a value that is one of some choices.
template <class Set>
FlagValue one_of(const std::vector<FlagChoice>& choices, Set set) {
    std::string form;
    for (const FlagChoice& choice : choices) form += (form.empty() ? "" : "|") + choice.name;
    return {.form = form,
            .choices = choices,
            .read = [=](RenderRequest& request, const std::string& text, const std::string&) {
                set(request, text);
            }};
}

/// Returns the rows of a table, which have `name` and `what`, as choices.
template <class Rows>
std::vector<FlagChoice> choices_of(const Rows& rows) {
    std::vector<FlagChoice> choices;
    choices.reserve(rows.size());
    for (const auto& row : rows)
        choices.push_back({.name = std::string(row.name), .what = std::string(row.what)});
    return choices;
}

/// Makes a value that is a number from `low` to `high`.
template <class Set>
FlagValue number(double low, double high, Set set) {
    FlagValue value = value_of("X", number_from(low, high), set);
    value.range = fmt::format("{} to {}", low, high);
    return value;
}

/// Makes a value that is a whole number from `low` to `high`.
template <class Set>
FlagValue whole(std::int64_t low, std::int64_t high, Set set) {
    FlagValue value = value_of("N", whole_from(low, high), set);
    value.range = fmt::format("{} to {}", low, high);
    return value;
}

}  // namespace sunfleck::engine
