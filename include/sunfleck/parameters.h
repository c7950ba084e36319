// Parameters of cameras, materials, lights, shapes ..., declared as in pbrt-v4's scene files.
//
// A declaration is a type and a name: "float roughness", "rgb reflectance", "spectrum eta",
// "texture amount", "point3 P", "string filename". The words are those of docs/reference/scenes.md.
#pragma once

#include <sunfleck/export.h>

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace sunfleck {

/// What a parameter holds: a truth value, numbers, whole numbers, or strings; one or a list.
class SUNFLECK_API Value {
public:
    using Data = std::variant<bool, std::vector<double>, std::vector<std::int32_t>,
                              std::vector<std::string>>;

    Value(bool flag) : data_(flag) {}
    Value(double number) : data_(std::vector<double>{number}) {}
    Value(int number) : data_(std::vector<std::int32_t>{number}) {}
    Value(const char* text) : Value(std::string(text)) {}
    Value(std::string text) : data_(std::vector<std::string>{std::move(text)}) {}
    Value(std::initializer_list<double> numbers) : data_(std::vector<double>(numbers)) {}
    Value(std::vector<double> numbers) : data_(std::move(numbers)) {}
    Value(std::vector<std::int32_t> numbers) : data_(std::move(numbers)) {}
    Value(std::vector<std::string> texts) : data_(std::move(texts)) {}
    Value(std::span<const float> numbers)
        : data_(std::vector<double>(numbers.begin(), numbers.end())) {}
    Value(std::span<const double> numbers)
        : data_(std::vector<double>(numbers.begin(), numbers.end())) {}
    Value(std::span<const std::int32_t> numbers)
        : data_(std::vector<std::int32_t>(numbers.begin(), numbers.end())) {}

    const Data& data() const { return data_; }

private:
    Data data_;
};

struct SUNFLECK_API Parameter {
    std::string declaration;  // "float roughness"
    Value value;
};

using Parameters = std::vector<Parameter>;

}  // namespace sunfleck
