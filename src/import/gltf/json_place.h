// JsonPlace: a value in a glTF file and where it stands, so that each fault is told with its place:
// lamp.gltf: meshes[2].primitives[0].material.
#pragma once

#include "math/vector.h"
#include "sunfleck/error.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunfleck::engine {

/// It refers to the document, which must outlive it.
class JsonPlace {
public:
    JsonPlace(const nlohmann::json& value, std::string file, std::string path)
        : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

    /// Returns the member of that name, or nothing; null is nothing, as some exporters write it.
    /// @throws Error  if this is no object.
    std::optional<JsonPlace> find(std::string_view key) const;
    /// @throws Error  if there is none.
    JsonPlace at(std::string_view key) const;
    /// Returns the number of elements of an array. @throws Error  if this is none.
    std::size_t size() const;
    /// @param i  below size().
    JsonPlace operator[](std::size_t i) const;
    /// Returns the elements of an array. @throws Error  if this is none.
    std::vector<JsonPlace> elements() const;
    /// Returns the elements of a member that is an array; none if there is no such member.
    std::vector<JsonPlace> elements(std::string_view key) const;

    /// Returns the members of an object with their names; none of anything else.
    std::vector<std::pair<std::string, JsonPlace>> members() const;

    /// Returns a finite number. @throws Error  for anything else.
    double number() const;
    double number(std::string_view key, double fallback) const;
    /// Returns a number between two others. @throws Error  for one that is not.
    double number(std::string_view key, double fallback, double least, double most) const;
    /// Returns a whole number of 0 to 2^53. @throws Error  for anything else.
    std::uint64_t whole() const;
    std::uint64_t whole(std::string_view key, std::uint64_t fallback) const;
    bool flag(std::string_view key, bool fallback) const;
    std::string text() const;
    std::string text(std::string_view key, const std::string& fallback) const;
    /// Returns finite numbers. @throws Error  if this is no array of `count` of them.
    std::vector<double> numbers(std::size_t count) const;
    Vec3d triple(std::string_view key, const Vec3d& fallback) const;

    /// Returns an index into a list of `count`. @throws Error  for one beyond its end.
    std::size_t index(std::size_t count, std::string_view of_what) const;

    /// Returns the extension of that name, or nothing.
    std::optional<JsonPlace> extension(std::string_view name) const;

    /// Returns a name of the value, the same for each place of it.
    const void* identity() const { return value_; }

    SourceLocation where() const { return {path_.empty() ? file_ : file_ + ": " + path_}; }
    [[noreturn]] void refuse(const std::string& what, const std::string& mend) const;

private:
    JsonPlace member(std::string_view key, const nlohmann::json& value) const;

    const nlohmann::json* value_;
    std::string file_;
    std::string path_;
};

}  // namespace sunfleck::engine
