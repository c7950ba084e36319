// Statement: a directive with typed parameters, looked up by name, with detection of unused ones.
#pragma once

#include "math/colour_space.h"
#include "math/vector.h"
#include "sunfleck/error.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

enum class ParameterType {
    boolean,
    integer,
    real,
    point2,
    vector2,
    point3,
    vector3,
    normal,
    rgb,
    blackbody,
    spectrum,
    text,
    texture
};

/// Returns the word of the language: "float", "bool", ...
std::string_view name_of(ParameterType type);
/// Returns the type of a word, or nothing.
std::optional<ParameterType> parameter_type(std::string_view word);
/// Returns the numbers per value; 0 for types without numbers, or with any count.
std::size_t components_of(ParameterType type);

struct Parameter {
    ParameterType type = ParameterType::real;
    std::string name;
    SourceLocation where;
    std::vector<double> numbers;  // of all types except integer, bool, string and texture
    std::vector<int> integers;    // of integer; of bool: 0 and 1
    std::vector<std::string> texts;
    ColourSpace space = ColourSpace::srgb;  // of an rgb
    mutable bool used = false;

    /// Returns "float radius", in quotes.
    std::string title() const;
};

using Parameters = std::vector<std::shared_ptr<const Parameter>>;

/// A directive with a type word and parameters: Shape "sphere" "float radius" 2. Of parameters with
/// the same name the last one counts; the block's defaults come after all of them.
///
/// Lookups by name throw Error for another type, or another number of values.
struct Statement {
    std::string keyword;
    std::string type;
    SourceLocation where;
    Parameters own;
    std::shared_ptr<const Parameters> defaults;  // or null

    /// Returns Shape "sphere".
    std::string title() const;

    /// Returns the parameter of that name and marks it as used, or null.
    const Parameter* find(std::string_view name) const;
    /// Returns the parameter, which must have the type, or null.
    const Parameter* find(std::string_view name, ParameterType type) const;

    std::optional<double> real(std::string_view name) const;
    double real(std::string_view name, double fallback) const {
        return real(name).value_or(fallback);
    }
    std::optional<int> integer(std::string_view name) const;
    bool flag(std::string_view name, bool fallback) const;
    std::optional<std::string> text(std::string_view name) const;
    Vec3d point(std::string_view name, const Vec3d& fallback) const;
    /// Returns `count` numbers. @param count  0 for any.
    std::optional<std::vector<double>> reals(std::string_view name, std::size_t count) const;

    /// Marks parameters as used that have no effect here.
    void ignore(std::initializer_list<std::string_view> names) const;
    void ignore_all() const;
    /// Returns own parameters that no lookup used.
    std::vector<const Parameter*> unused() const;
};

}  // namespace sunfleck::engine
