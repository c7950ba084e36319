// The table of named textures, each made when something asks for it.
#include "import/pbrt/textures.h"

#include "import/pbrt/version3.h"
#include "import/pbrt/words.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

constexpr int kDeepest = 100;
constexpr double kMostLookups = 100'000;

/// One name, as a texture parameter must have.
const Parameter& checked(const Parameter& parameter) {
    if (parameter.texts.size() == 1) return parameter;
    throw Error(parameter.where,
                "parameter " + parameter.title() + " has " +
                    std::to_string(parameter.texts.size()) + " values",
                "give the name of one texture");
}

}  // namespace

void TextureTable::add(const std::string& kind, const std::string& name, Statement statement,
                       const Matrix& to_world) {
    if (is_parameter_type_of_v3(kind))
        refuse_v3("Texture " + in_quotes(name) + " " + in_quotes(kind), statement.where);
    if (kind != "float" && kind != "spectrum")
        throw Error(statement.where, "unknown kind of texture " + in_quotes(kind),
                    "use \"float\" or \"spectrum\"");
    const auto classes = texture_classes();
    if (std::find(classes.begin(), classes.end(), statement.type) == classes.end())
        throw Error(statement.where, "unknown texture " + in_quotes(statement.type),
                    use_one_of(classes, statement.type));
    const SourceLocation where = statement.where;
    Entry entry{std::move(statement), to_world, textures_.size(), {}, {}, {}};
    if (!textures_.try_emplace({kind, name}, std::move(entry)).second)
        throw Error(where, "a second " + kind + " texture " + in_quotes(name),
                    "give it another name");
}

TextureTable::Entry& TextureTable::entry_of(const std::string& kind, const Parameter& parameter) {
    const auto found = textures_.find({kind, checked(parameter).texts[0]});
    if (found != textures_.end() && found->second.order < limit_) return found->second;
    throw Error(parameter.where,
                "there is no " + kind + " texture " + in_quotes(parameter.texts[0]),
                "make it by Texture before, or check the name");
}

/// Of parts that are not given, pbrt-v4's constants.
template <class T>
TextureParts<T> TextureTable::parts_of(const Statement& statement, SpectrumUse use) {
    TextureParts<T> parts;
    for (const TexturePart& part : texture_parts(statement.type)) {
        const auto number = [&] {
            return find_number(statement, part.name).value_or(part.fallback);
        };
        if (part.is_number)
            parts.numbers.emplace(part.name, number());
        else if constexpr (std::is_same_v<T, FloatTexture>)
            parts.own.emplace(part.name, number());
        else
            parts.own.emplace(part.name, find_spectrum(statement, part.name, use)
                                             .value_or(Spectrum::constant(part.fallback)));
    }
    return parts;
}

/// Notes how deep the tree below the texture is, and how deep that makes the one above.
template <class T>
T TextureTable::make(Entry& entry, SpectrumUse use) {
    const auto check = [&](int depth) {
        if (depth > kDeepest)
            throw Error(entry.statement.where, "textures are nested more than 100 deep",
                        "use fewer of them");
    };
    check(++open_);
    const std::size_t limit_above = std::exchange(limit_, entry.order);
    const Tree above = std::exchange(below_, {});
    T texture = texture_of<T>({entry.statement, entry.to_world, use},
                              parts_of<T>(entry.statement, use), images_, log_);
    limit_ = limit_above;
    const Tree below = std::exchange(below_, above);
    entry.tree = {below.depth + 1, below.lookups + 1};
    check(entry.tree.depth);
    if (entry.tree.lookups > kMostLookups)
        throw Error(entry.statement.where,
                    "a texture of more than 100000 others, each as often as it is asked for",
                    "use fewer of them");
    --open_;
    return texture;
}

FloatTexture TextureTable::number(const Parameter& parameter) {
    Entry& entry = entry_of("float", parameter);
    if (!entry.number) entry.number = make<FloatTexture>(entry, SpectrumUse::reflectance);
    below_.add(entry.tree);
    return *entry.number;
}

SpectrumTexture TextureTable::spectrum(const Parameter& parameter, SpectrumUse use) {
    Entry& entry = entry_of("spectrum", parameter);
    const auto known = entry.spectra.find(use);
    SpectrumTexture texture =
        known != entry.spectra.end() ? known->second : make<SpectrumTexture>(entry, use);
    entry.spectra.try_emplace(use, texture);
    below_.add(entry.tree);
    return texture;
}

std::optional<FloatTexture> TextureTable::find_number(const Statement& statement,
                                                      std::string_view name) {
    const Parameter* found = statement.find(name);
    if (!found) return std::nullopt;
    if (found->type == ParameterType::texture) return number(*found);
    return static_cast<float>(*statement.real(name));
}

std::optional<SpectrumTexture> TextureTable::find_spectrum(const Statement& statement,
                                                           std::string_view name, SpectrumUse use) {
    const Parameter* found = statement.find(name);
    if (!found) return std::nullopt;
    if (found->type == ParameterType::texture) return spectrum(*found, use);
    return SpectrumTexture(spectra_.curve(*found, use));
}

}  // namespace sunfleck::engine
