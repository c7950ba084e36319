// PLY headers: the elements of the file, and the storage of their numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

enum class PlyFormat { ascii, little_endian, big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Returns the bytes of one number in a binary file.
constexpr std::size_t ply_size(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        case PlyType::float64:
            return 8;
    }
    return 8;
}

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    std::optional<PlyType> count_type;  // of a list

    bool is_list() const { return count_type.has_value(); }
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;  // in body order; names are distinct
    std::size_t size = 0;              // in bytes: offset of the body

    /// Returns the element of that name, or null.
    const PlyElement* find(std::string_view name) const;
};

/// Parses a header.
/// @throws Error  with line and column, for what is not a PLY header, or has no vertex with x, y, z
/// or no face with a list of vertex indices.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& name);

/// Returns whether this is the list of a face's vertices.
inline bool is_vertex_list(const PlyProperty& property) {
    return property.name == "vertex_indices" || property.name == "vertex_index";
}

}  // namespace sunfleck::engine
