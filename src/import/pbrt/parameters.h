// Typed parameters of one statement, looked up by name; what nobody asked for is told.
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

/// The word that the language has for it: "float", "bool", ...
std::string_view name_of(ParameterType type);
/// The type of a word, or nothing.
std::optional<ParameterType> parameter_type(std::string_view word);
/// Numbers that make one value; 0 for types that hold no real numbers, or any number of them.
std::size_t components_of(ParameterType type);

struct Parameter {
    ParameterType type = ParameterType::real;
    std::string name;
    SourceLocation where;
    std::vector<double> numbers;  // of all types but integer, bool, string and texture
    std::vector<int> integers;    // of integer; of bool: 0 and 1
    std::vector<std::string> texts;
    ColourSpace space = ColourSpace::srgb;  // of an rgb
    mutable bool used = false;

    /// "float radius", in quotes.
    std::string title() const;
};

using Parameters = std::vector<std::shared_ptr<const Parameter>>;

/// A directive with a type word and parameters: Shape "sphere" "float radius" 2. Of parameters of
/// the same name the last one counts; the block's defaults come after all of them.
///
/// Lookups by name throw Error for another type than asked for, or another number of values.
struct Statement {
    std::string keyword;
    std::string type;
    SourceLocation where;
    Parameters own;
    std::shared_ptr<const Parameters> defaults;  // or null

    /// Shape "sphere".
    std::string title() const;

    /// The parameter of that name, marked as used, or null.
    const Parameter* find(std::string_view name) const;
    /// The same; it must be of the type.
    const Parameter* find(std::string_view name, ParameterType type) const;

    std::optional<double> real(std::string_view name) const;
    double real(std::string_view name, double fallback) const {
        return real(name).value_or(fallback);
    }
    std::optional<int> integer(std::string_view name) const;
    bool flag(std::string_view name, bool fallback) const;
    std::optional<std::string> text(std::string_view name) const;
    Vec3d point(std::string_view name, const Vec3d& fallback) const;
    /// `count` numbers. @param count  0: any.
    std::optional<std::vector<double>> reals(std::string_view name, std::size_t count) const;

    /// VisibleFlags parameters that are known to have no meaning here.
    void ignore(std::initializer_list<std::string_view> names) const;
    void ignore_all() const;
    /// Own parameters that no lookup asked for.
    std::vector<const Parameter*> unused() const;
};

}  // namespace sunfleck::engine
