// The table of named textures, each converted at its first use.
#include "import/pbrt/textures.h"

#include "import/pbrt/version3.h"
#include "import/pbrt/words.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

constexpr int kDeepest = 100;
constexpr double kMostLookups = 100'000;

/// Checks that a texture parameter has one name.
const Parameter& checked(const Parameter& parameter) {
    if (parameter.texts.size() == 1) return parameter;
    throw Error(parameter.where,
                "parameter " + parameter.title() + " has " +
                    std::to_string(parameter.texts.size()) + " values",
                "give the name of one texture");
}

/// Gives a variable its value back at the end of a block, also when it ends by an exception.
template <class T>
class Restored {
public:
    explicit Restored(T& variable) : variable_(variable), before_(variable) {}
    ~Restored() { variable_ = before_; }
    Restored(const Restored&) = delete;
    Restored& operator=(const Restored&) = delete;
    Restored(Restored&&) = delete;
    Restored& operator=(Restored&&) = delete;

private:
    T& variable_;
    T before_;
};

}  // namespace

void TextureTable::add(const std::string& kind, const std::string& name, Statement statement,
                       const Matrix& to_world) {
    log_.count_word(statement.keyword, statement.type);
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
    if (found != textures_.end() && found->second.order < at_.limit) return found->second;
    throw Error(parameter.where,
                "there is no " + kind + " texture " + in_quotes(parameter.texts[0]),
                "make the texture before what uses it, or check its name and kind");
}

/// Inputs that are not given have pbrt-v4's defaults.
template <class T>
TextureOperands<T> TextureTable::operands_of(const Statement& statement, SpectrumUse use) {
    TextureOperands<T> operands;
    for (const TextureOperand& operand : texture_operands(statement.type)) {
        const auto number = [&] {
            return find_number(statement, operand.name).value_or(operand.fallback);
        };
        if (operand.is_number)
            operands.numbers.emplace(operand.name, number());
        else if constexpr (std::is_same_v<T, FloatTexture>)
            operands.own.emplace(operand.name, number());
        else
            operands.own.emplace(operand.name, find_spectrum(statement, operand.name, use)
                                                   .value_or(Spectrum::constant(operand.fallback)));
    }
    return operands;
}

/// Converts a texture and records the depth of its tree.
template <class T>
T TextureTable::make(Entry& entry, SpectrumUse use) {
    const auto check = [&](int depth) {
        if (depth > kDeepest)
            throw Error(entry.statement.where, "textures are nested more than 100 deep",
                        "use fewer levels");
    };
    const Restored back(at_);
    at_ = {entry.order, {}, at_.open + 1};
    check(at_.open);
    T texture = texture_of<T>({entry.statement, entry.to_world, use},
                              operands_of<T>(entry.statement, use), images_, log_);
    entry.tree = {at_.below.depth + 1, at_.below.lookups + 1};
    check(entry.tree.depth);
    if (entry.tree.lookups > kMostLookups)
        throw Error(entry.statement.where, "the tree of this texture has more than 100000 nodes",
                    "use fewer textures");
    return texture;
}

FloatTexture TextureTable::number(const Parameter& parameter) {
    Entry& entry = entry_of("float", parameter);
    if (!entry.number) entry.number = make<FloatTexture>(entry, SpectrumUse::reflectance);
    at_.below.add(entry.tree);
    return *entry.number;
}

SpectrumTexture TextureTable::spectrum(const Parameter& parameter, SpectrumUse use) {
    Entry& entry = entry_of("spectrum", parameter);
    const auto known = entry.spectra.find(use);
    SpectrumTexture texture =
        known != entry.spectra.end() ? known->second : make<SpectrumTexture>(entry, use);
    entry.spectra.try_emplace(use, texture);
    at_.below.add(entry.tree);
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
