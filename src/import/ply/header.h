// The header of a PLY file: which elements follow, and how each of their numbers is stored.
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

/// Bytes of one number in a binary file.
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
    std::vector<PlyElement> elements;  // as they follow in the body; names distinct
    std::size_t size = 0;              // bytes: the body begins there

    /// The element of that name, or null.
    const PlyElement* find(std::string_view name) const;
};

/// @throws Error with line and column: what is no PLY header, or lacks a vertex with x, y, z or a
///         face with a list of vertex indices.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& name);

/// Is this the list of a face's vertices?
inline bool is_vertex_list(const PlyProperty& property) {
    return property.name == "vertex_indices" || property.name == "vertex_index";
}

}  // namespace sunfleck::engine
