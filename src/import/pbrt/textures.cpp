// Named textures; constants are evaluated, the rest is named in warnings.
#include "import/pbrt/textures.h"

#include "import/pbrt/reading.h"
#include "import/pbrt/words.h"

#include <algorithm>
#include <array>

namespace sunfleck {
namespace {

constexpr std::array<std::string_view, 13> kClasses = {
    "constant", "imagemap", "scale", "mix",  "checkerboard", "bilerp",      "dots",
    "fbm",      "marble",   "windy", "ptex", "wrinkled",     "directionmix"};

std::string shown(double value) {
    std::string text = std::to_string(value);
    while (text.back() == '0') text.pop_back();
    return text.back() == '.' ? text + "0" : text;
}

void warn_stand_in(const Parameter& parameter, const Statement& texture, double stand_in,
                   Reading& reading) {
    reading.warn(parameter.where, "texture " + in_quotes(parameter.texts[0]) + " (" + texture.type +
                                      ") is not read: " + in_quotes(parameter.name) + " is " +
                                      shown(stand_in) + " everywhere");
}

/// One name, as a texture parameter must have.
const Parameter& checked(const Parameter& parameter) {
    if (parameter.texts.size() == 1) return parameter;
    throw Error(parameter.where,
                "parameter " + parameter.title() + " has " +
                    std::to_string(parameter.texts.size()) + " values",
                "give the name of one texture");
}

}  // namespace

void TextureTable::add(const std::string& kind, const std::string& name, Statement statement) {
    if (kind != "float" && kind != "spectrum")
        throw Error(statement.where, "unknown kind of texture " + in_quotes(kind),
                    "use \"float\" or \"spectrum\"");
    if (std::find(kClasses.begin(), kClasses.end(), statement.type) == kClasses.end())
        throw Error(statement.where, "unknown texture " + in_quotes(statement.type),
                    use_one_of(kClasses, statement.type));
    const SourceLocation where = statement.where;
    if (!textures_.try_emplace({kind, name}, std::move(statement)).second)
        throw Error(where, "a second " + kind + " texture " + in_quotes(name),
                    "give it another name");
}

const Statement& TextureTable::at(const std::string& kind, const Parameter& parameter) const {
    const auto found = textures_.find({kind, checked(parameter).texts[0]});
    if (found != textures_.end()) return found->second;
    throw Error(parameter.where,
                "there is no " + kind + " texture " + in_quotes(parameter.texts[0]),
                "make it by Texture before, or check the name");
}

std::optional<SpectralCurve> find_textured_curve(const Statement& statement, std::string_view name,
                                                 SpectrumUse use, float stand_in,
                                                 Reading& reading) {
    const Parameter* found = statement.find(name);
    if (!found) return std::nullopt;
    if (found->type != ParameterType::texture) return curve_of(*found, use, reading);
    const Statement& texture = reading.textures.at("spectrum", *found);
    if (texture.type != "constant") {
        warn_stand_in(*found, texture, stand_in, reading);
        return SpectralCurve::constant(stand_in);
    }
    const auto value = find_curve(texture, "value", use, reading);
    return value ? *value : SpectralCurve::constant(1);
}

std::optional<double> find_textured_real(const Statement& statement, std::string_view name,
                                         double stand_in, Reading& reading) {
    const Parameter* found = statement.find(name);
    if (!found) return std::nullopt;
    if (found->type != ParameterType::texture) return statement.real(name);
    const Statement& texture = reading.textures.at("float", *found);
    if (texture.type == "constant") return texture.real("value", 1);
    warn_stand_in(*found, texture, stand_in, reading);
    return stand_in;
}

}  // namespace sunfleck
