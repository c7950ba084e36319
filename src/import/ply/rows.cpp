// Reads the rows of a PLY body, number by number.
#include "import/ply/rows.h"

#include "core/float_range.h"
#include "core/printable.h"
#include "import/ply/number_source.h"
#include "sunfleck/error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Target of a vertex's number; the last value is for unused numbers.
enum Slot : std::size_t { slot_x, slot_nx = 3, slot_u = 6, slot_v, slot_red, slot_none = 11 };
using VertexRow = std::array<double, slot_none + 1>;

constexpr std::array<std::string_view, 6> kVectorNames = {"x", "y", "z", "nx", "ny", "nz"};
constexpr std::array<std::array<std::string_view, 2>, 4> kUvNames = {
    {{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}};

constexpr std::array<std::string_view, 3> kColourNames = {"red", "green", "blue"};

bool has_number(const PlyElement& element, std::string_view name) {
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [&](const PlyProperty& p) { return p.name == name && !p.is_list(); });
}

struct VertexLayout {
    std::vector<Slot> slots;  // one per property
    bool normals = false;
    bool uvs = false;
    double colour_scale = 0;  // to [0,1]; 0 without colours
};

/// Returns what makes colours of a type go to 1.
double colour_scale_of(PlyType type) {
    if (type == PlyType::float32 || type == PlyType::float64) return 1;
    return type == PlyType::uint16 ? 1.0 / 65535 : 1.0 / 255;
}

VertexLayout layout_of(const PlyElement& vertex) {
    VertexLayout layout;
    layout.normals =
        has_number(vertex, "nx") && has_number(vertex, "ny") && has_number(vertex, "nz");
    const auto* uv = std::find_if(kUvNames.begin(), kUvNames.end(), [&](const auto& names) {
        return has_number(vertex, names[0]) && has_number(vertex, names[1]);
    });
    layout.uvs = uv != kUvNames.end();
    const bool has_colours =
        std::all_of(kColourNames.begin(), kColourNames.end(),
                    [&](std::string_view name) { return has_number(vertex, name); });
    for (const PlyProperty& property : vertex.properties) {
        const auto* colour = std::find(kColourNames.begin(), kColourNames.end(), property.name);
        const auto* found = std::find(kVectorNames.begin(), kVectorNames.end(), property.name);
        auto slot = slot_none;
        if (found != kVectorNames.end())
            slot = static_cast<Slot>(found - kVectorNames.begin());
        else if (layout.uvs && property.name == (*uv)[0])
            slot = slot_u;
        else if (layout.uvs && property.name == (*uv)[1])
            slot = slot_v;
        else if (has_colours && colour != kColourNames.end())
            slot = static_cast<Slot>(slot_red + (colour - kColourNames.begin()));
        if (slot == slot_red) layout.colour_scale = colour_scale_of(property.type);
        if (slot >= slot_nx && slot < slot_u && !layout.normals) slot = slot_none;
        layout.slots.push_back(property.is_list() ? slot_none : slot);
    }
    return layout;
}

template <class Source>
class BodyReader {
public:
    BodyReader(const PlyHeader& header, std::string_view body, const std::string& name)
        : header_(header), source_(body), name_(name) {}

    PlyBody read() {
        for (const PlyElement& element : header_.elements) {
            element_ = &element;
            row_ = 0;
            if (element.properties.empty()) continue;
            if (!source_.room_for(element))
                throw Error({name_},
                            "the header claims " + std::to_string(element.count) + " of " +
                                in_quotes(element.name) + ", more than the file can hold",
                            "write the file again; it is truncated or damaged");
            try {
                read_element(element);
            } catch (const PlyFault& fault) {
                fail(fault.what(), "write the file again; it is truncated or damaged");
            }
        }
        return std::move(body_);
    }

private:
    void read_element(const PlyElement& element) {
        if (element.name == "vertex") {
            read_vertices(element);
        } else if (element.name == "face") {
            read_faces(element);
        } else {
            for (; row_ < element.count; ++row_)
                for (const PlyProperty& property : element.properties) skip(property);
        }
    }

    void skip(const PlyProperty& property) {
        source_.skip(property.is_list() ? list_length(property) : 1, property.type);
    }

    std::uint64_t list_length(const PlyProperty& property) {
        const double length = source_.number(*property.count_type);
        if (!(length >= 0 && length <= 0x1p32 && length == std::floor(length)))
            fail("a list " + in_quotes(property.name) + " with an invalid length",
                 "write the file again; it is damaged");
        return static_cast<std::uint64_t>(length);
    }

    void read_vertices(const PlyElement& element) {
        const VertexLayout layout = layout_of(element);
        mesh_.positions.reserve(element.count);
        if (layout.normals) mesh_.normals.reserve(element.count);
        if (layout.uvs) mesh_.uvs.reserve(element.count);
        if (layout.colour_scale > 0) mesh_.colours.reserve(element.count);
        for (; row_ < element.count; ++row_) {
            VertexRow row{};
            for (std::size_t i = 0; i < layout.slots.size(); ++i) {
                const PlyProperty& property = element.properties[i];
                if (property.is_list())
                    skip(property);
                else
                    row.at(layout.slots[i]) = source_.number(property.type);
            }
            add_vertex(row, layout);
        }
    }

    /// Normals, texture coordinates, and all numbers of an unused vertex may be NaN, which
    /// exporters write for missing values.
    void add_vertex(const VertexRow& row, const VertexLayout& layout) {
        const auto are_floats = [&](std::size_t first, std::size_t last) {
            return std::all_of(row.begin() + first, row.begin() + last + 1, is_finite_float);
        };
        mesh_.positions.emplace_back(row[slot_x], row[slot_x + 1], row[slot_x + 2]);
        if (!are_floats(slot_x, slot_x + 2)) body_.broken.push_back(row_);
        const auto any = [&](std::size_t slot) { return static_cast<float>(row.at(slot)); };
        if (layout.normals)
            mesh_.normals.emplace_back(any(slot_nx), any(slot_nx + 1), any(slot_nx + 2));
        const auto colour = [&](std::size_t slot) {
            const double value = row.at(slot) * layout.colour_scale;
            return value > 0 ? static_cast<float>(std::min(value, 1.0)) : 0.0F;
        };
        if (layout.colour_scale > 0)
            mesh_.colours.emplace_back(colour(slot_red), colour(slot_red + 1),
                                       colour(slot_red + 2));
        if (!layout.uvs) return;
        const bool has_uv = are_floats(slot_u, slot_v);
        mesh_.uvs.emplace_back(has_uv ? Vec2d(row[slot_u], row[slot_v]) : Vec2d(0));
        if (!has_uv) ++body_.broken_uvs;
    }

    void read_faces(const PlyElement& element) {
        mesh_.triangles.reserve(element.count);
        body_.has_face_uvs =
            mesh_.uvs.empty() && std::any_of(element.properties.begin(), element.properties.end(),
                                             [](const auto& p) { return p.name == "texcoord"; });
        for (; row_ < element.count; ++row_) {
            for (const PlyProperty& property : element.properties) {
                if (is_vertex_list(property))
                    read_face(property);
                else
                    skip(property);
            }
        }
    }

    void read_face(const PlyProperty& property) {
        const std::uint64_t length = list_length(property);
        corners_.clear();
        for (std::uint64_t i = 0; i < length; ++i) corners_.push_back(vertex_index(property.type));
        if (length < 3) ++body_.faces_left_out;
        if (length > 4) body_.fans.push_back({row_, mesh_.triangles.size(), length});
        for (std::size_t i = 2; i < length; ++i)
            mesh_.triangles.push_back({corners_[0], corners_[i - 1], corners_[i]});
    }

    std::uint32_t vertex_index(PlyType type) {
        const double index = source_.number(type);
        const std::uint64_t vertices = header_.find("vertex")->count;
        if (!(index >= 0 && index < static_cast<double>(vertices) && index == std::floor(index) &&
              index <= 0xFFFFFFFFp0))
            fail("it names a vertex that does not exist: the file has " + std::to_string(vertices),
                 "export the mesh again");
        return static_cast<std::uint32_t>(index);
    }

    [[noreturn]] void fail(const std::string& what, const std::string& mend) {
        throw Error({name_},
                    printable(element_->name, 40) + " " + std::to_string(row_) + ": " + what, mend);
    }

    const PlyHeader& header_;
    Source source_;
    const std::string& name_;
    const PlyElement* element_ = nullptr;
    std::uint64_t row_ = 0;
    PlyBody body_;
    PlyMesh& mesh_ = body_.mesh;
    std::vector<std::uint32_t> corners_;  // of the current face
};

}  // namespace

PlyBody read_rows(const PlyHeader& header, std::string_view body, const std::string& name) {
    if (header.format == PlyFormat::ascii)
        return BodyReader<PlyTextSource>(header, body, name).read();
    if (header.format == PlyFormat::little_endian)
        return BodyReader<PlyBinarySource<std::endian::little>>(header, body, name).read();
    return BodyReader<PlyBinarySource<std::endian::big>>(header, body, name).read();
}

}  // namespace sunfleck::engine
