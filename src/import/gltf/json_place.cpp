// Typed access to JSON values; what has another type is refused by its place.
#include "import/gltf/json_place.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

std::string in_quotes(std::string_view text) {
    return '"' + std::string(text) + '"';
}

}  // namespace

void JsonPlace::refuse(const std::string& what, const std::string& mend) const {
    throw Error(where(), what, mend);
}

JsonPlace JsonPlace::member(std::string_view key, const nlohmann::json& value) const {
    return {value, file_, path_.empty() ? std::string(key) : path_ + "." + std::string(key)};
}

std::optional<JsonPlace> JsonPlace::find(std::string_view key) const {
    if (!value_->is_object()) refuse("is not an object", "write { } with its members");
    const auto found = value_->find(key);
    if (found == value_->end() || found->is_null()) return {};
    return member(key, *found);
}

JsonPlace JsonPlace::at(std::string_view key) const {
    const auto found = find(key);
    if (!found) refuse("has no " + in_quotes(key), "export the file again");
    return *found;
}

std::size_t JsonPlace::size() const {
    if (!value_->is_array()) refuse("is not a list", "write [ ] with its elements");
    return value_->size();
}

JsonPlace JsonPlace::operator[](std::size_t i) const {
    return {(*value_)[i], file_, path_ + "[" + std::to_string(i) + "]"};
}

std::vector<JsonPlace> JsonPlace::elements() const {
    std::vector<JsonPlace> all;
    all.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) all.push_back((*this)[i]);
    return all;
}

std::vector<JsonPlace> JsonPlace::elements(std::string_view key) const {
    const auto found = find(key);
    return found ? found->elements() : std::vector<JsonPlace>();
}

std::vector<std::pair<std::string, JsonPlace>> JsonPlace::members() const {
    std::vector<std::pair<std::string, JsonPlace>> all;
    if (value_->is_object())
        for (const auto& [key, value] : value_->items()) all.emplace_back(key, member(key, value));
    return all;
}

double JsonPlace::number() const {
    if (value_->is_number())
        if (const double x = value_->get<double>(); std::isfinite(x)) return x;
    refuse("is not a number", "write a finite number");
}

double JsonPlace::number(std::string_view key, double fallback) const {
    const auto found = find(key);
    return found ? found->number() : fallback;
}

double JsonPlace::number(std::string_view key, double fallback, double least, double most) const {
    const auto found = find(key);
    if (!found) return fallback;
    const double x = found->number();
    if (x >= least && x <= most) return x;
    const bool has_end = std::isfinite(most);
    found->refuse("is out of range", has_end
                                         ? "write a number of " + nlohmann::json(least).dump() +
                                               " to " + nlohmann::json(most).dump()
                                         : "write " + nlohmann::json(least).dump() + " or more");
}

std::uint64_t JsonPlace::whole() const {
    constexpr double kMost = 0x1p53;
    if (value_->is_number())
        if (const double x = value_->get<double>(); x >= 0 && x <= kMost && x == std::floor(x))
            return static_cast<std::uint64_t>(x);
    refuse("is not a whole number", "write a whole number of 0 or more");
}

std::uint64_t JsonPlace::whole(std::string_view key, std::uint64_t fallback) const {
    const auto found = find(key);
    return found ? found->whole() : fallback;
}

bool JsonPlace::flag(std::string_view key, bool fallback) const {
    const auto found = find(key);
    if (!found) return fallback;
    if (!found->value_->is_boolean())
        found->refuse("is neither true nor false", "write one of them");
    return found->value_->get<bool>();
}

std::string JsonPlace::text() const {
    if (!value_->is_string()) refuse("is not a text", "write it in quotes");
    return value_->get<std::string>();
}

std::string JsonPlace::text(std::string_view key, const std::string& fallback) const {
    const auto found = find(key);
    return found ? found->text() : fallback;
}

std::vector<double> JsonPlace::numbers(std::size_t count) const {
    const std::vector<JsonPlace> all = elements();
    if (all.size() != count)
        refuse("has " + std::to_string(all.size()) + " numbers", "write " + std::to_string(count));
    std::vector<double> values;
    for (const JsonPlace& one : all) values.push_back(one.number());
    return values;
}

Vec3d JsonPlace::triple(std::string_view key, const Vec3d& fallback) const {
    const auto found = find(key);
    if (!found) return fallback;
    const std::vector<double> v = found->numbers(3);
    return {v[0], v[1], v[2]};
}

std::size_t JsonPlace::index(std::size_t count, std::string_view of_what) const {
    const std::uint64_t i = whole();
    if (i < count) return static_cast<std::size_t>(i);
    refuse(
        "names " + std::string(of_what) + " " + std::to_string(i) + " of " + std::to_string(count),
        "export the file again");
}

std::optional<JsonPlace> JsonPlace::extension(std::string_view name) const {
    const auto all = find("extensions");
    return all ? all->find(name) : std::nullopt;
}

}  // namespace sunfleck::engine
