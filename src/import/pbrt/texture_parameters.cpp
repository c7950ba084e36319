// Shared parameters of textures, with pbrt-v4's defaults.
#include "import/pbrt/texture_parameters.h"

#include "import/pbrt/words.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace sunfleck::engine {
namespace {

Encoding encoding_of(const Statement& statement) {
    const std::string word = statement.text("encoding").value_or("sRGB");
    if (word == "sRGB") return {};
    if (word == "linear") return {Encoding::Kind::linear, 1};
    float exponent = 0;
    if (std::sscanf(word.c_str(), "gamma %f", &exponent) == 1 && exponent > 0 && exponent < 100)
        return {Encoding::Kind::gamma, exponent};
    throw Error(statement.find("encoding")->where, "unknown encoding " + in_quotes(word),
                "use \"sRGB\", \"linear\" or \"gamma 2.2\"");
}

}  // namespace

Vec3 TextureInput::vector(std::string_view name, const Vec3& fallback) const {
    const Parameter* found = statement.find(name, ParameterType::vector3);
    if (!found) return fallback;
    if (found->numbers.size() != 3)
        throw Error(found->where, "parameter " + found->title() + " is not a vector", "give 3");
    return {Vec3d(found->numbers[0], found->numbers[1], found->numbers[2])};
}

std::size_t TextureInput::choice(std::string_view name,
                                 std::span<const std::string_view> words) const {
    const std::string word = statement.text(name).value_or(std::string(words[0]));
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    throw Error(statement.find(name)->where, "unknown " + in_quotes(name) + " " + in_quotes(word),
                use_one_of(words, word));
}

Mapping mapping_of(const TextureInput& input) {
    static constexpr std::array<std::string_view, 4> kWords = {"uv", "spherical", "cylindrical",
                                                               "planar"};
    const std::size_t kind = input.choice("mapping", kWords);
    if (kind == 1) return SphericalMapping{input.to_texture()};
    if (kind == 2) return CylindricalMapping{input.to_texture()};
    const Vec2 shift(input.real("udelta", 0), input.real("vdelta", 0));
    if (kind == 3)
        return PlanarMapping{input.to_texture(), input.vector("v1", {1, 0, 0}),
                             input.vector("v2", {0, 1, 0}), shift};
    return UvMapping{{input.real("uscale", 1), input.real("vscale", 1)}, shift};
}

Octaves octaves_of(const TextureInput& input) {
    constexpr int kMost = 32;  // finer octaves are below float precision
    return {std::clamp(input.statement.integer("octaves").value_or(8), 0, kMost),
            input.real("roughness", 0.5)};
}

ImageKind image_of(const TextureInput& input, ImageTable& images, ImportLog& log) {
    static constexpr std::array<std::string_view, 4> kWraps = {"repeat", "black", "clamp",
                                                               "octahedralsphere"};
    static constexpr std::array<std::string_view, 5> kFilters = {"bilinear", "point", "trilinear",
                                                                 "ewa", "EWA"};
    const Statement& statement = input.statement;
    const auto name = statement.text("filename");
    if (!name || name->empty())
        throw Error(statement.where, "an imagemap without a file", "add \"string filename\"");
    ImageKind kind;
    kind.mapping = mapping_of(input);
    kind.wraps = static_cast<Wrap>(input.choice("wrap", kWraps));
    const std::size_t filter = input.choice("filter", kFilters);
    kind.nearest = filter == 1;
    if (filter > 1)
        log.warn(statement.where,
                 "images are not filtered by distance: \"trilinear\" and "
                 "\"ewa\" are read as \"bilinear\"");
    kind.scale = input.real("scale", 1);
    kind.invert = statement.flag("invert", false);
    kind.image = images.enter(*name, encoding_of(statement), statement.where);
    statement.ignore({"maxanisotropy"});
    return kind;
}

}  // namespace sunfleck::engine
