// A walk through all textures of a material.
#include "export/coordinates.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Returns whether pbrt-v4 lacks a mapping.
bool is_unsayable(const Mapping& mapping) {
    const auto* turned = std::get_if<TurnedUvMapping>(&mapping);
    return (turned != nullptr && (turned->u.y != 0 || turned->v.x != 0)) ||
           std::holds_alternative<VertexMapping>(mapping);
}

bool is_same(const TurnedUvMapping& a, const TurnedUvMapping& b) {
    return a.u == b.u && a.v == b.v && a.shift == b.shift;
}

/// The mappings of all textures below those that are added.
class Mappings {
public:
    void add(const FloatTexture& texture) {
        if (texture.kind()) std::visit(*this, texture.kind()->kind);
    }
    void add(const SpectrumTexture& texture) {
        if (texture.kind()) std::visit(*this, texture.kind()->kind);
    }

    template <class T>
    void operator()(const ScaledKind<T>& m) {
        add(m.texture);
        add(m.factor);
    }
    template <class T>
    void operator()(const MixKind<T>& m) {
        add(m.first);
        add(m.second);
        add(m.amount);
    }
    template <class T>
    void operator()(const DirectionMixKind<T>& m) {
        add(m.first);
        add(m.second);
    }
    template <class T>
    void operator()(const CheckerboardKind<T>& m) {
        if (const auto* mapping = std::get_if<Mapping>(&m.mapping)) found_.push_back(*mapping);
        add(m.first);
        add(m.second);
    }
    template <class T>
    void operator()(const DotsKind<T>& m) {
        found_.push_back(m.mapping);
        add(m.inside);
        add(m.outside);
    }
    template <class T>
    void operator()(const BilerpKind<T>& m) {
        found_.push_back(m.mapping);
        for (const T* corner : {&m.v00, &m.v01, &m.v10, &m.v11}) add(*corner);
    }
    void operator()(const ImageKind& m) { found_.push_back(m.mapping); }
    void operator()(const VertexColourKind& m) {
        if (m.image) found_.push_back(m.image->mapping);
    }
    void operator()(const VertexNumberKind&) {}
    void operator()(const FbmKind&) {}
    void operator()(const WrinkledKind&) {}
    void operator()(const WindyKind&) {}
    void operator()(const MarbleKind&) {}

    const std::vector<Mapping>& found() const { return found_; }

private:
    std::vector<Mapping> found_;
};

/// The mappings of a material, and whether it needs the coordinates of the mesh as they are.
struct MaterialMappings {
    const std::vector<Material>& materials;
    Mappings mappings{};
    bool has_direction = false;

    void add(const Roughness& roughness) {
        mappings.add(roughness.u);
        mappings.add(roughness.v);
        const bool is_even = roughness.u.kind() == roughness.v.kind() &&
                             roughness.u.constant() == roughness.v.constant();
        has_direction = has_direction || !is_even;
    }
    void add(const Coat& coat) {
        if (const auto& facets = coat.facets())
            has_direction = has_direction || facets->alpha_x != facets->alpha_y;
    }
    void operator()(const DiffuseMaterial& m) { mappings.add(m.reflectance); }
    void operator()(const DielectricMaterial& m) { add(m.roughness); }
    void operator()(const ThinDielectricMaterial& m) { mappings.add(m.colour); }
    void operator()(const ConductorMaterial& m) {
        if (m.reflectance) mappings.add(*m.reflectance);
        mappings.add(m.eta);
        mappings.add(m.k);
        add(m.roughness);
    }
    void operator()(const IridescentConductorMaterial& m) { (*this)(m.metal); }
    void operator()(const CoatedDiffuseMaterial& m) {
        mappings.add(m.reflectance);
        add(*m.coat);
    }
    void operator()(const CoatedConductorMaterial& m) {
        (*this)(m.metal);
        add(*m.coat);
    }
    void operator()(const DiffuseTransmissionMaterial& m) {
        mappings.add(m.reflectance);
        mappings.add(m.transmittance);
    }
    void operator()(const MixMaterial& m) {
        mappings.add(m.amount);
        for (const std::uint32_t part : m.components) std::visit(*this, materials[part]);
    }
    void operator()(const InterfaceMaterial&) {}
};

}  // namespace

bool is_same(const Mapping& a, const Mapping& b) {
    const auto* turned_a = std::get_if<TurnedUvMapping>(&a);
    const auto* turned_b = std::get_if<TurnedUvMapping>(&b);
    if (turned_a && turned_b) return is_same(*turned_a, *turned_b);
    const auto* vertex_a = std::get_if<VertexMapping>(&a);
    const auto* vertex_b = std::get_if<VertexMapping>(&b);
    return vertex_a != nullptr && vertex_b != nullptr &&
           vertex_a->coordinates.values == vertex_b->coordinates.values &&
           is_same(vertex_a->turned, vertex_b->turned);
}

std::optional<Mapping> common_mapping(const ShapeDescription& shape,
                                      const std::vector<Material>& materials,
                                      const std::vector<BumpMap>& bump_maps) {
    const auto* mesh = std::get_if<TriangleMesh>(&shape.placed.shape);
    const bool has_bumps = shape.material < bump_maps.size() && !is_flat(bump_maps[shape.material]);
    const bool has_mask = shape.placed.cover && !shape.alpha;
    if (!mesh || has_bumps || has_mask || (shape.emission && shape.emission->image)) return {};
    MaterialMappings all{materials};
    std::visit(all, materials[shape.material]);
    if (shape.alpha) all.mappings.add(*shape.alpha);
    const std::vector<Mapping>& found = all.mappings.found();
    if (found.empty() || all.has_direction || !is_unsayable(found.front())) return {};
    const bool all_alike = std::all_of(found.begin(), found.end(), [&](const Mapping& mapping) {
        return is_same(mapping, found.front());
    });
    return all_alike ? std::optional(found.front()) : std::nullopt;
}

std::vector<Vec2> mapped_coordinates(const TriangleMesh& mesh, const Mapping& mapping) {
    std::vector<Vec2> result(mesh.positions.size(), Vec2(0));
    const auto* vertices = std::get_if<VertexMapping>(&mapping);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            TexturePoint point;
            point.primitive = static_cast<std::uint32_t>(t);
            point.weights = {k == 1 ? 1.0F : 0.0F, k == 2 ? 1.0F : 0.0F};
            const std::uint32_t corner = mesh.triangles[t].at(k);
            if (!vertices && !mesh.uvs.empty()) point.uv = mesh.uvs[corner];
            result[corner] = place(mapping, point);
        }
    return result;
}

}  // namespace sunfleck::engine
