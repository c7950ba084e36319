// Parameters of cameras, materials, lights, shapes ..., declared as in pbrt-v4's scene files.
//
// A declaration is a type and a name: "float roughness", "rgb reflectance", "spectrum eta",
// "texture amount", "point3 P", "string filename". The words are those of docs/reference/scenes.md.
#pragma once

#include <sunfleck/export.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace sunfleck {

/// A number of any type, but no truth value and no character.
template <class T>
concept Numeric = std::floating_point<T> ||
    (std::integral<T> && !std::same_as<T, bool> && !std::same_as<T, char> &&
     !std::same_as<T, wchar_t> && !std::same_as<T, char8_t> && !std::same_as<T, char16_t> &&
     !std::same_as<T, char32_t>);

template <class T>
concept NumericRange = std::ranges::sized_range<T> && Numeric<std::ranges::range_value_t<T>>;

/// What a parameter holds: a truth value, numbers, whole numbers, or strings; one or a list.
class SUNFLECK_API Value {
public:
    using Data = std::variant<bool, std::vector<double>, std::vector<std::int32_t>,
                              std::vector<std::string>>;

    Value(std::same_as<bool> auto flag) : data_(flag) {}
    Value(Numeric auto number) : data_(list_of(std::array{number})) {}
    Value(const char* text) : Value(std::string(text)) {}
    Value(std::string_view text) : Value(std::string(text)) {}
    Value(std::string text) : data_(std::vector<std::string>{std::move(text)}) {}
    Value(std::initializer_list<double> numbers) : data_(std::vector<double>(numbers)) {}
    template <std::convertible_to<std::string_view> Text>
    Value(std::initializer_list<Text> texts)
        : data_(std::vector<std::string>(texts.begin(), texts.end())) {}
    Value(std::vector<double> numbers) : data_(std::move(numbers)) {}
    Value(std::vector<std::int32_t> numbers) : data_(std::move(numbers)) {}
    Value(std::vector<std::string> texts) : data_(std::move(texts)) {}
    /// A vector, an array or a span of numbers.
    template <NumericRange Numbers>
    Value(const Numbers& numbers) : data_(list_of(numbers)) {}

    const Data& data() const { return data_; }

private:
    /// Returns whole numbers if all are such and fit, else numbers.
    template <class Numbers>
    static Data list_of(const Numbers& numbers) {
        using Number = std::ranges::range_value_t<Numbers>;
        if constexpr (std::integral<Number>) {
            std::vector<std::int32_t> whole;
            whole.reserve(std::ranges::size(numbers));
            for (const Number number : numbers)
                if (std::in_range<std::int32_t>(number))
                    whole.push_back(static_cast<std::int32_t>(number));
            if (whole.size() == std::ranges::size(numbers)) return whole;
        }
        std::vector<double> list;
        list.reserve(std::ranges::size(numbers));
        for (const Number number : numbers) list.push_back(static_cast<double>(number));
        return list;
    }

    Data data_;
};

struct SUNFLECK_API Parameter {
    std::string declaration;  // "float roughness"
    Value value;
};

using Parameters = std::vector<Parameter>;

}  // namespace sunfleck
