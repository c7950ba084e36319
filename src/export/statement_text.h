// StatementText: one statement of a pbrt-v4 scene with its parameters, as text.
//
// Numbers are the shortest ones that read back to the same float or double.
#pragma once

#include "geometry/affine.h"
#include "math/vector.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sunfleck::engine {

std::string exact_number(float value);
std::string exact_number(double value);

/// Returns `Transform [ ... ]` as a line, empty for the identity.
std::string transform_text(const Matrix& to_world);
Matrix matrix_of(const Affine& map);

/// Returns statements in a frame of their own, as a block; as they are without one.
std::string placed_text(const std::optional<Matrix>& to_world, const std::string& statements);

class StatementText {
public:
    /// @param directive  such as Shape. @param word  such as sphere, written in quotes.
    StatementText(std::string_view directive, std::string_view word);
    /// `Texture "name" "float" "imagemap"` and the like.
    StatementText(std::string_view directive, std::initializer_list<std::string_view> words);

    void add(std::string_view name, float value) { add("float", name, exact_number(value)); }
    void add(std::string_view name, double value) { add("float", name, exact_number(value)); }
    void add(std::string_view name, int value) { add("integer", name, std::to_string(value)); }
    void add(std::string_view name, bool value) { add("bool", name, value ? "true" : "false"); }
    /// Adds a text, or the name of what `type` is: "string", "texture".
    void add_word(std::string_view type, std::string_view name, std::string_view word);
    /// Adds a parameter whose value is `values`, as it is to be written between brackets.
    void add(std::string_view type, std::string_view name, const std::string& values);
    void add(std::string_view type, std::string_view name, const Vec3d& values);
    void add(std::string_view type, std::string_view name, const Vec3& values);
    void add(std::string_view type, std::string_view name, std::span<const Vec3> values);
    void add(std::string_view type, std::string_view name, std::span<const Vec2> values);

    /// Returns the statement with a line break after each parameter.
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

}  // namespace sunfleck::engine
