// Numbers and parameters as text.
#include "export/statement_text.h"

#include <array>
#include <charconv>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kValuesPerLine = 6;

template <class Number>
std::string shortest_text(Number value) {
    std::array<char, 64> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end.ptr};
}

template <class Triple>
std::string triple_text(const Triple& v) {
    return exact_number(v.x) + ' ' + exact_number(v.y) + ' ' + exact_number(v.z);
}

std::string tuple_text(const Vec3& v) {
    return triple_text(v);
}

std::string tuple_text(const Vec2& v) {
    return exact_number(v.x) + ' ' + exact_number(v.y);
}

template <class Tuple>
std::string list_text(std::span<const Tuple> values) {
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) text += i % kValuesPerLine == 0 ? "\n        " : "  ";
        text += tuple_text(values[i]);
    }
    return text;
}

}  // namespace

std::string exact_number(float value) {
    return shortest_text(value);
}

std::string exact_number(double value) {
    return shortest_text(value);
}

std::string transform_text(const Matrix& to_world) {
    if (to_world == Matrix()) return {};
    std::string text = "Transform [";
    for (const auto& row : to_world.x)
        for (const double value : row) text += ' ' + exact_number(value + 0.0);  // no -0
    return text + " ]\n";
}

Matrix matrix_of(const Affine& map) {
    return {map.x.x, map.x.y, map.x.z, 0, map.y.x,      map.y.y,      map.y.z,      0,
            map.z.x, map.z.y, map.z.z, 0, map.origin.x, map.origin.y, map.origin.z, 1};
}

std::string placed_text(const std::optional<Matrix>& to_world, const std::string& statements) {
    if (!to_world || *to_world == Matrix()) return statements;
    return "AttributeBegin\n" + transform_text(*to_world) + statements + "AttributeEnd\n";
}

StatementText::StatementText(std::string_view directive, std::string_view word)
    : StatementText(directive, {word}) {}

StatementText::StatementText(std::string_view directive,
                             std::initializer_list<std::string_view> words)
    : text_(directive) {
    for (const std::string_view word : words) text_.append(" \"").append(word).append("\"");
    text_ += '\n';
}

void StatementText::add(std::string_view type, std::string_view name, const std::string& values) {
    text_.append("    \"").append(type).append(" ").append(name).append("\" [ ");
    text_.append(values).append(" ]\n");
}

void StatementText::add_word(std::string_view type, std::string_view name, std::string_view word) {
    std::string quoted = "\"";
    for (const char c : word) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    add(type, name, quoted + '"');
}

void StatementText::add(std::string_view type, std::string_view name, const Vec3d& values) {
    add(type, name, triple_text(values));
}

void StatementText::add(std::string_view type, std::string_view name, const Vec3& values) {
    add(type, name, triple_text(values));
}

void StatementText::add(std::string_view type, std::string_view name,
                        std::span<const Vec3> values) {
    add(type, name, list_text(values));
}

void StatementText::add(std::string_view type, std::string_view name,
                        std::span<const Vec2> values) {
    add(type, name, list_text(values));
}

}  // namespace sunfleck::engine
