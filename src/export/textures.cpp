// One overload for each kind of texture.
#include "export/textures.h"

#include "export/coordinates.h"
#include "export/mappings.h"
#include "export/spectra.h"

#include <fmt/format.h>

#include <optional>
#include <type_traits>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Returns the mean colour of vertices.
Vec3 mean_of(const std::vector<Vec3>& colours) {
    Vec3d sum(0);
    for (const Vec3& colour : colours) sum += Vec3d(colour);
    return colours.empty() ? Vec3(1) : Vec3(sum / static_cast<double>(colours.size()));
}

float mean_of(const std::vector<Vec2>& numbers) {
    double sum = 0;
    for (const Vec2& number : numbers) sum += static_cast<double>(number.x);
    return numbers.empty() ? 1 : static_cast<float>(sum / static_cast<double>(numbers.size()));
}

std::string_view word_of(Wrap wrap) {
    switch (wrap) {
        case Wrap::black:
            return "black";
        case Wrap::clamp:
            return "clamp";
        case Wrap::octahedral_sphere:
            return "octahedralsphere";
        case Wrap::repeat:
        case Wrap::mirror:  // its picture repeats
            break;
    }
    return "repeat";
}

}  // namespace

/// The statement of one texture, by its kind.
struct TextureStatements {
    TextureWriter& writer;
    std::string_view type;  // "float" or "spectrum"
    ColourUse use;          // of a spectrum
    std::string name;
    std::optional<Matrix> frame{};

    StatementText begin(std::string_view word) const { return {"Texture", {name, type, word}}; }

    template <class T>
    void add(StatementText& statement, std::string_view as, const T& texture) const {
        if constexpr (std::is_same_v<T, FloatTexture>)
            writer.add(statement, as, texture);
        else
            writer.add(statement, as, texture, use);
    }

    template <class M>
    void map(StatementText& statement, const M& mapping) {
        const MappingText text = written(mapping);
        add_mapping(statement, text.mapping);
        frame = text.frame;
    }

    template <class T>
    StatementText operator()(const ScaledKind<T>& m) {
        StatementText statement = begin("scale");
        add(statement, "tex", m.texture);
        writer.add(statement, "scale", m.factor);
        return statement;
    }
    template <class T>
    StatementText operator()(const MixKind<T>& m) {
        StatementText statement = begin("mix");
        add(statement, "tex1", m.first);
        add(statement, "tex2", m.second);
        writer.add(statement, "amount", m.amount);
        return statement;
    }
    template <class T>
    StatementText operator()(const DirectionMixKind<T>& m) {
        StatementText statement = begin("directionmix");
        add(statement, "tex1", m.first);
        add(statement, "tex2", m.second);
        statement.add("vector3", "dir", m.direction);
        return statement;
    }
    template <class T>
    StatementText operator()(const CheckerboardKind<T>& m) {
        StatementText statement = begin("checkerboard");
        if (std::holds_alternative<PointMapping>(m.mapping)) statement.add("dimension", 3);
        std::visit([&](const auto& mapping) { map(statement, mapping); }, m.mapping);
        add(statement, "tex1", m.first);
        add(statement, "tex2", m.second);
        return statement;
    }
    template <class T>
    StatementText operator()(const DotsKind<T>& m) {
        StatementText statement = begin("dots");
        map(statement, m.mapping);
        add(statement, "inside", m.inside);
        add(statement, "outside", m.outside);
        return statement;
    }
    template <class T>
    StatementText operator()(const BilerpKind<T>& m) {
        StatementText statement = begin("bilerp");
        map(statement, m.mapping);
        add(statement, "v00", m.v00);
        add(statement, "v01", m.v01);
        add(statement, "v10", m.v10);
        add(statement, "v11", m.v11);
        return statement;
    }

    StatementText operator()(const FloatImageKind& m) { return image(m); }
    StatementText operator()(const SpectrumImageKind& m) { return image(m); }

    StatementText operator()(const FbmKind& m) { return noise("fbm", m.mapping, m.octaves); }
    StatementText operator()(const WrinkledKind& m) {
        return noise("wrinkled", m.mapping, m.octaves);
    }
    StatementText operator()(const WindyKind& m) {
        StatementText statement = begin("windy");
        map(statement, m.mapping);
        return statement;
    }
    StatementText operator()(const MarbleKind& m) {
        StatementText statement = noise("marble", m.mapping, m.octaves);
        statement.add("scale", m.scale);
        statement.add("variation", m.variation);
        return statement;
    }

    StatementText operator()(const VertexNumberKind& m) {
        writer.warn("numbers of vertices have no texture in pbrt-v4: their mean is written");
        StatementText statement = begin("constant");
        statement.add("value", mean_of(*m.numbers.values));
        return statement;
    }
    StatementText operator()(const VertexColourKind& m) {
        writer.warn("colours of vertices have no texture in pbrt-v4: their mean is written");
        const Vec3 mean = mean_of(*m.colours.values);
        if (!m.image) {
            StatementText statement = begin("constant");
            add_spectrum(statement, "value", Spectrum::rgb_albedo(mean), use);
            return statement;
        }
        SpectrumImageKind coloured{*m.image, ColourUse::albedo};
        coloured.image = rgb_floats(*m.image->image, mean);
        return image(coloured);
    }

private:
    /// Warns of what is lost, unless meshes have the mapping.
    template <class M>
    MappingText written(const M& mapping) const {
        if constexpr (std::is_same_v<M, Mapping>)
            if (writer.of_meshes_ && is_same(mapping, *writer.of_meshes_)) return {};
        MappingText text = written_mapping(mapping);
        if (!text.lost.empty()) writer.warn(text.lost);
        return text;
    }

    StatementText noise(std::string_view word, const PointMapping& mapping,
                        const Octaves& octaves) {
        StatementText statement = begin(word);
        map(statement, mapping);
        statement.add("octaves", octaves.count);
        statement.add("roughness", octaves.roughness);
        return statement;
    }

    StatementText image(const ImageKind& m) {
        StatementText statement = begin("imagemap");
        const bool across = m.wraps.across == Wrap::mirror;
        const bool down = m.wraps.down == Wrap::mirror;
        MappingText text = written(m.mapping);
        if (auto* uv = std::get_if<UvMapping>(&text.mapping)) {
            if (across) *uv = {uv->scale * Vec2(0.5F, 1), uv->shift * Vec2(0.5F, 1)};
            if (down)  // rows of the picture go against v
                *uv = {uv->scale * Vec2(1, 0.5F), uv->shift * Vec2(1, 0.5F) + Vec2(0, 0.5F)};
        } else if (across || down) {
            writer.warn("pictures on places in space cannot be mirrored: they repeat");
        }
        const bool is_on_uv = std::holds_alternative<UvMapping>(text.mapping);
        const PictureFiles::Entry& file = is_on_uv && (across || down)
                                              ? writer.pictures_.mirrored(m.image, across, down)
                                              : writer.pictures_.texture(m.image);
        statement.add_word("string", "filename", file.name);
        if (!file.encoding.empty()) statement.add_word("string", "encoding", file.encoding);
        add_mapping(statement, text.mapping);
        frame = text.frame;
        add_look(statement, m);
        return statement;
    }

    void add_look(StatementText& statement, const ImageKind& m) const {
        const std::string_view wrap = word_of(m.wraps.across);
        if (wrap != word_of(m.wraps.down))
            writer.warn(
                "pbrt-v4 continues a picture beyond its edges in one way: that across is "
                "written for both");
        if (wrap != "repeat") statement.add_word("string", "wrap", wrap);
        if (m.nearest) statement.add_word("string", "filter", "point");
        if (m.scale != 1) statement.add("scale", m.scale);
        if (m.invert) statement.add("invert", true);
    }
};

std::string TextureWriter::name_of(const FloatKind& kind) {
    const auto known = numbers_.find({&kind, has_mapping_of_meshes()});
    if (known != numbers_.end()) return known->second;
    TextureStatements make{*this, "float", ColourUse::albedo, fmt::format("t{}", ++count_)};
    const StatementText statement = std::visit(make, kind.kind);
    text_ += placed_text(make.frame, statement.text());
    return numbers_.emplace(std::pair{&kind, has_mapping_of_meshes()}, make.name).first->second;
}

std::string TextureWriter::name_of(const SpectrumKind& kind, ColourUse use) {
    const auto known = spectra_.find({&kind, use, has_mapping_of_meshes()});
    if (known != spectra_.end()) return known->second;
    TextureStatements make{*this, "spectrum", use, fmt::format("t{}", ++count_)};
    const StatementText statement = std::visit(make, kind.kind);
    text_ += placed_text(make.frame, statement.text());
    return spectra_.emplace(std::tuple{&kind, use, has_mapping_of_meshes()}, make.name)
        .first->second;
}

void TextureWriter::add(StatementText& statement, std::string_view name,
                        const FloatTexture& texture) {
    if (texture.is_constant()) return statement.add(name, texture.constant());
    statement.add_word("texture", name, name_of(*texture.kind()));
}

void TextureWriter::add(StatementText& statement, std::string_view name,
                        const SpectrumTexture& texture, ColourUse use) {
    if (texture.is_constant()) return add_spectrum(statement, name, texture.curve(), use);
    statement.add_word("texture", name, name_of(*texture.kind(), use));
}

}  // namespace sunfleck::engine
