// pbrt-v4 scales and shifts the coordinates of the mesh, or takes places in space.
#include "export/mappings.h"

namespace sunfleck::engine {
namespace {

Matrix frame_of(const Affine& to_texture) {
    return matrix_of(to_texture.inverse());
}

struct WrittenMapping {
    MappingText operator()(const UvMapping& m) const { return {m}; }
    MappingText operator()(const TurnedUvMapping& m) const {
        MappingText text{UvMapping{{m.u.x, m.v.y}, m.shift}};
        if (m.u.y != 0 || m.v.x != 0)
            text.lost =
                "coordinates of textures cannot be turned: these are scaled and shifted "
                "alone";
        return text;
    }
    MappingText operator()(const VertexMapping& m) const {
        MappingText text = (*this)(m.turned);
        text.lost =
            "a mesh has one set of coordinates for textures: those of a second one use the "
            "first";
        return text;
    }
    MappingText operator()(const SphericalMapping& m) const { return {m, frame_of(m.to_texture)}; }
    MappingText operator()(const CylindricalMapping& m) const {
        return {m, frame_of(m.to_texture)};
    }
    MappingText operator()(const PlanarMapping& m) const { return {m, frame_of(m.to_texture)}; }
};

void add_shift(StatementText& statement, const Vec2& shift) {
    if (shift.x != 0) statement.add("udelta", shift.x);
    if (shift.y != 0) statement.add("vdelta", shift.y);
}

struct AddMapping {
    StatementText& statement;

    void operator()(const UvMapping& m) const {
        if (m.scale.x != 1) statement.add("uscale", m.scale.x);
        if (m.scale.y != 1) statement.add("vscale", m.scale.y);
        add_shift(statement, m.shift);
    }
    void operator()(const TurnedUvMapping&) const {}  // written as an UvMapping
    void operator()(const VertexMapping&) const {}    // likewise
    void operator()(const SphericalMapping&) const {
        statement.add_word("string", "mapping", "spherical");
    }
    void operator()(const CylindricalMapping&) const {
        statement.add_word("string", "mapping", "cylindrical");
    }
    void operator()(const PlanarMapping& m) const {
        statement.add_word("string", "mapping", "planar");
        statement.add("vector3", "v1", m.v1);
        statement.add("vector3", "v2", m.v2);
        add_shift(statement, m.shift);
    }
};

}  // namespace

MappingText written_mapping(const Mapping& mapping) {
    return std::visit(WrittenMapping{}, mapping);
}

MappingText written_mapping(const PointMapping& mapping) {
    return {UvMapping{}, frame_of(mapping.to_texture)};
}

void add_mapping(StatementText& statement, const Mapping& mapping) {
    std::visit(AddMapping{statement}, mapping);
}

}  // namespace sunfleck::engine
