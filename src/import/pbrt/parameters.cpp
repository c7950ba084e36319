// Lookups of parameters by name and type.
#include "import/pbrt/parameters.h"

#include "import/pbrt/words.h"

#include <algorithm>
#include <array>
#include <utility>

namespace sunfleck::engine {
namespace {

/// The first word of a type is its name in messages.
constexpr std::array<std::pair<std::string_view, ParameterType>, 16> kTypes = {{
    {"bool", ParameterType::boolean},
    {"integer", ParameterType::integer},
    {"float", ParameterType::real},
    {"point2", ParameterType::point2},
    {"vector2", ParameterType::vector2},
    {"point3", ParameterType::point3},
    {"vector3", ParameterType::vector3},
    {"normal", ParameterType::normal},
    {"rgb", ParameterType::rgb},
    {"blackbody", ParameterType::blackbody},
    {"spectrum", ParameterType::spectrum},
    {"string", ParameterType::text},
    {"texture", ParameterType::texture},
    {"point", ParameterType::point3},
    {"vector", ParameterType::vector3},
    {"normal3", ParameterType::normal},
}};

/// The last of that name, or null.
const Parameter* last_of(const Parameters& list, std::string_view name) {
    const auto found =
        std::find_if(list.rbegin(), list.rend(), [&](const auto& p) { return p->name == name; });
    return found == list.rend() ? nullptr : found->get();
}

[[noreturn]] void wrong_count(const Parameter& parameter, std::size_t count, std::size_t wanted) {
    throw Error(parameter.where,
                "parameter " + parameter.title() + " has " + std::to_string(count) +
                    (count == 1 ? " value" : " values"),
                "give " + std::to_string(wanted));
}

const Parameter* single(const Statement& statement, std::string_view name, ParameterType type) {
    const Parameter* found = statement.find(name, type);
    if (!found) return nullptr;
    const std::size_t count = found->numbers.size() + found->integers.size() + found->texts.size();
    const std::size_t wanted = std::max<std::size_t>(components_of(type), 1);
    if (count != wanted) wrong_count(*found, count, wanted);
    return found;
}

}  // namespace

std::string_view name_of(ParameterType type) {
    return std::find_if(kTypes.begin(), kTypes.end(),
                        [&](const auto& t) { return t.second == type; })
        ->first;
}

std::optional<ParameterType> parameter_type(std::string_view word) {
    const auto* const found =
        std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& t) { return t.first == word; });
    if (found == kTypes.end()) return std::nullopt;
    return found->second;
}

std::size_t components_of(ParameterType type) {
    switch (type) {
        case ParameterType::real:
        case ParameterType::blackbody:
            return 1;
        case ParameterType::point2:
        case ParameterType::vector2:
            return 2;
        case ParameterType::point3:
        case ParameterType::vector3:
        case ParameterType::normal:
        case ParameterType::rgb:
            return 3;
        default:
            return 0;
    }
}

std::string Parameter::title() const {
    return in_quotes(std::string(name_of(type)) + " " + name);
}

std::string Statement::title() const {
    return keyword == "MakeNamedMaterial" ? keyword : keyword + " " + in_quotes(type);
}

const Parameter* Statement::find(std::string_view name) const {
    const Parameter* found = last_of(own, name);
    if (!found && defaults) found = last_of(*defaults, name);
    if (found) found->used = true;
    return found;
}

const Parameter* Statement::find(std::string_view name, ParameterType type) const {
    const Parameter* found = find(name);
    if (found && found->type != type)
        throw Error(found->where,
                    "parameter " + found->title() + " of " + title() + " has the wrong type",
                    "write " + in_quotes(std::string(name_of(type)) + " " + found->name));
    return found;
}

std::optional<double> Statement::real(std::string_view name) const {
    const Parameter* found = single(*this, name, ParameterType::real);
    if (!found) return std::nullopt;
    return found->numbers[0];
}

std::optional<int> Statement::integer(std::string_view name) const {
    const Parameter* found = single(*this, name, ParameterType::integer);
    if (!found) return std::nullopt;
    return found->integers[0];
}

bool Statement::flag(std::string_view name, bool fallback) const {
    const Parameter* found = single(*this, name, ParameterType::boolean);
    return found ? found->integers[0] != 0 : fallback;
}

std::optional<std::string> Statement::text(std::string_view name) const {
    const Parameter* found = single(*this, name, ParameterType::text);
    if (!found) return std::nullopt;
    return found->texts[0];
}

Vec3d Statement::point(std::string_view name, const Vec3d& fallback) const {
    const Parameter* found = single(*this, name, ParameterType::point3);
    if (!found) return fallback;
    return {found->numbers[0], found->numbers[1], found->numbers[2]};
}

std::optional<std::vector<double>> Statement::reals(std::string_view name,
                                                    std::size_t count) const {
    const Parameter* found = find(name, ParameterType::real);
    if (!found) return std::nullopt;
    if (count != 0 && found->numbers.size() != count)
        wrong_count(*found, found->numbers.size(), count);
    return found->numbers;
}

void Statement::ignore(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names) find(name);
}

void Statement::ignore_all() const {
    for (const auto& parameter : own) parameter->used = true;
}

std::vector<const Parameter*> Statement::unused() const {
    std::vector<const Parameter*> result;
    for (const auto& parameter : own)
        if (!parameter->used) result.push_back(parameter.get());
    return result;
}

}  // namespace sunfleck::engine
