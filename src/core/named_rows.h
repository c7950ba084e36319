// Tables of what a user may write: rows, and how they are looked up by name.
#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

namespace sunfleck::engine {

/// A choice of a setting.
template <class Value>
struct ChoiceRow {
    Value value;
    std::string_view name;  // as the user writes it
    std::string_view what;
};

/// @param rows  each with a `name`. @return the row of that name, or null.
template <class Rows>
constexpr auto row_named(const Rows& rows, std::string_view name) -> decltype(std::data(rows)) {
    const auto found = std::find_if(std::begin(rows), std::end(rows),
                                    [&](const auto& row) { return row.name == name; });
    return found == std::end(rows) ? nullptr : &*found;
}

}  // namespace sunfleck::engine
