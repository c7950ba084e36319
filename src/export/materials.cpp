// One overload for each material.
#include "export/materials.h"

#include "export/coated_colours.h"
#include "export/film_colours.h"
#include "export/spectra.h"
#include "math/colour.h"

#include <fmt/format.h>

#include <utility>

namespace sunfleck::engine {

/// The parameters of a material.
struct MaterialStatements {
    MaterialWriter& writer;
    StatementText& statement;

    void operator()(const DiffuseMaterial& m) const {
        type("diffuse");
        colour("reflectance", m.reflectance);
    }

    void operator()(const DielectricMaterial& m) const {
        type("dielectric");
        add_index(statement, "eta", m.eta);
        roughness("", m.roughness);
    }

    void operator()(const ThinDielectricMaterial& m) const {
        type("thindielectric");
        add_index(statement, "eta", m.eta);
        const bool is_clear = m.colour.is_constant() && m.colour.curve().is_constant() &&
                              m.colour.curve()(kFirstNm) == 1;
        if (!is_clear) warn("thin glass has no colour in pbrt-v4: it is written clear");
    }

    void operator()(const ConductorMaterial& m) const {
        type("conductor");
        metal("", m);
    }

    void operator()(const IridescentConductorMaterial& m) const {
        warn(
            "pbrt-v4 has no thin films: metal under one is written as metal of its colour along "
            "the normal, or without it where the metal's own colour is a texture");
        ConductorMaterial metal = m.metal;
        if (const auto colour = film_colour(m)) metal.reflectance = *colour;
        (*this)(metal);
    }

    void operator()(const CoatedDiffuseMaterial& m) const {
        const CoatedColour made = m.whole ? colour_below(m) : CoatedColour{m.reflectance};
        writer.made_.push_back(made.colour);
        type(made.has_coat ? "coateddiffuse" : "diffuse");
        colour("reflectance", made.colour);
        if (made.has_coat) coat("", *m.coat, false);
    }

    void operator()(const CoatedConductorMaterial& m) const {
        type("coatedconductor");
        metal("conductor.", m.metal);
        coat("interface.", *m.coat, m.metal.roughness.remap);
    }

    void operator()(const DiffuseTransmissionMaterial& m) const {
        type("diffusetransmission");
        colour("reflectance", m.reflectance);
        colour("transmittance", m.transmittance);
    }

    void operator()(const MixMaterial& m) const {
        type("mix");
        const std::string first = writer.name_of(m.components[0]);
        const std::string second = writer.name_of(m.components[1]);
        statement.add("string", "materials", '"' + first + "\" \"" + second + '"');
        number("amount", m.amount);
    }

    void operator()(const InterfaceMaterial&) const { type("interface"); }

private:
    void type(std::string_view word) const { statement.add_word("string", "type", word); }
    void warn(const std::string& text) const { writer.textures_.warn(text); }
    void colour(std::string_view name, const SpectrumTexture& texture,
                ColourUse use = ColourUse::albedo) const {
        writer.textures_.add(statement, name, texture, use);
    }
    void number(const std::string& name, const FloatTexture& texture) const {
        writer.textures_.add(statement, name, texture);
    }

    void roughness(const std::string& prefix, const Roughness& r) const {
        const bool is_smooth = r.is_constant() && r.u.constant() == 0 && r.v.constant() == 0;
        if (is_smooth && !r.remap) statement.add("remaproughness", false);
        if (is_smooth) return;
        number(prefix + "uroughness", r.u);
        number(prefix + "vroughness", r.v);
        if (!r.remap) statement.add("remaproughness", false);
        if (r.gives_back)
            warn(
                "in pbrt-v4 rough metal and glass lose what goes from facet to facet: it is not "
                "given back");
    }

    void metal(const std::string& prefix, const ConductorMaterial& m) const {
        if (m.reflectance) {
            colour("reflectance", *m.reflectance);
        } else {
            colour(prefix + "eta", m.eta, ColourUse::unbounded);
            colour(prefix + "k", m.k, ColourUse::unbounded);
        }
        roughness(prefix, m.roughness);
    }

    /// @param remap  as the metal's roughness below is written, which has no flag of its own.
    void coat(const std::string& prefix, const Coat& coat, bool remap) const {
        statement.add(prefix + "eta", coat.eta());
        statement.add(prefix + "thickness", coat.thickness());
        if (const auto& facets = coat.facets()) {
            const auto written = [&](float alpha) { return remap ? alpha * alpha : alpha; };
            statement.add(prefix + "uroughness", written(facets->alpha_x));
            statement.add(prefix + "vroughness", written(facets->alpha_y));
        }
        if (prefix.empty()) statement.add("remaproughness", remap);
    }

    CoatedColour colour_below(const CoatedDiffuseMaterial& m) const {
        auto made = coated_colour(*m.coat, m.reflectance);
        if (!made)
            warn(
                "the colour of glTF's plastic by such textures is written as that of the base "
                "under its coat, which is brighter");
        if (made && !made->has_coat)
            warn(
                "a rough coat loses light in pbrt-v4: bright rough plastic is written as a diffuse "
                "surface that reflects as much");
        return made.value_or(CoatedColour{m.reflectance});
    }
};

std::string MaterialWriter::name_of(std::uint32_t number) {
    const std::pair key{number, textures_.has_mapping_of_meshes()};
    const auto known = names_.find(key);
    if (known != names_.end()) return known->second;
    std::string name = fmt::format("m{}{}", number + 1, key.second ? "-mapped" : "");
    StatementText statement("MakeNamedMaterial", name);
    std::visit(MaterialStatements{*this, statement}, materials_[number]);
    if (number < bump_maps_.size()) add_bump_map(statement, bump_maps_[number]);
    text_ += statement.text();
    return names_.emplace(key, std::move(name)).first->second;
}

std::string MaterialWriter::use(std::uint32_t number) {
    if (std::holds_alternative<InterfaceMaterial>(materials_[number]))
        return "Material \"interface\"\n";
    return "NamedMaterial \"" + name_of(number) + "\"\n";
}

}  // namespace sunfleck::engine
