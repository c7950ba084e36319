// Classes of textures by their words, with pbrt-v4's parameters and defaults.
#include "import/pbrt/texture_kinds.h"

#include "import/pbrt/words.h"

#include <algorithm>
#include <array>

namespace sunfleck::engine {
namespace {

/// What the makers of all classes need.
template <class T>
struct Making {
    const TextureInput& input;
    const TextureParts<T>& parts;
    ImageTable& images;
    ImportLog& log;

    const T& part(std::string_view name) const { return parts.own.at(name); }
    const FloatTexture& number(std::string_view name) const { return parts.numbers.at(name); }
};

using MakingNumber = Making<FloatTexture>;
using MakingSpectrum = Making<SpectrumTexture>;

template <class T>
struct KindOf;
template <>
struct KindOf<FloatTexture> {
    using Kind = FloatKind;
};
template <>
struct KindOf<SpectrumTexture> {
    using Kind = SpectrumKind;
};

template <class T>
using Kind = typename KindOf<T>::Kind;

template <class T>
T constant(const Making<T>& m) {
    return m.part("value");
}

template <class T>
T scale(const Making<T>& m) {
    return T(Kind<T>{ScaledKind<T>{m.part("tex"), m.number("scale")}});
}

template <class T>
T mix(const Making<T>& m) {
    return T(Kind<T>{MixKind<T>{m.part("tex1"), m.part("tex2"), m.number("amount")}});
}

template <class T>
T direction_mix(const Making<T>& m) {
    const Vec3d direction =
        Affine(m.input.to_world).vector(Vec3d(m.input.vector("dir", {0, 1, 0})));
    return T(
        Kind<T>{DirectionMixKind<T>{m.part("tex1"), m.part("tex2"), Vec3(direction.normalized())}});
}

template <class T>
T checkerboard(const Making<T>& m) {
    const Statement& statement = m.input.statement;
    const int dimension = statement.integer("dimension").value_or(2);
    if (dimension != 2 && dimension != 3)
        throw Error(statement.find("dimension")->where,
                    "a checkerboard of " + std::to_string(dimension) + " dimensions", "use 2 or 3");
    CheckerboardKind<T> kind{mapping_of(m.input), m.part("tex1"), m.part("tex2")};
    if (dimension == 3) kind.mapping = PointMapping{m.input.to_texture()};
    return T(Kind<T>{std::move(kind)});
}

template <class T>
T dots(const Making<T>& m) {
    return T(Kind<T>{DotsKind<T>{mapping_of(m.input), m.part("inside"), m.part("outside")}});
}

template <class T>
T bilerp(const Making<T>& m) {
    return T(Kind<T>{BilerpKind<T>{mapping_of(m.input), m.part("v00"), m.part("v01"), m.part("v10"),
                                   m.part("v11")}});
}

ColourUse colour_use(SpectrumUse use) {
    if (use == SpectrumUse::reflectance) return ColourUse::albedo;
    return use == SpectrumUse::emission ? ColourUse::illuminant : ColourUse::unbounded;
}

FloatTexture float_image(const MakingNumber& m) {
    return FloatTexture(FloatKind{FloatImageKind{image_of(m.input, m.images, m.log)}});
}

SpectrumTexture spectrum_image(const MakingSpectrum& m) {
    return SpectrumTexture(SpectrumKind{
        SpectrumImageKind{image_of(m.input, m.images, m.log), colour_use(m.input.use)}});
}

FloatTexture fbm_texture(const MakingNumber& m) {
    return FloatTexture(FloatKind{FbmKind{{m.input.to_texture()}, octaves_of(m.input)}});
}

FloatTexture wrinkled(const MakingNumber& m) {
    return FloatTexture(FloatKind{WrinkledKind{{m.input.to_texture()}, octaves_of(m.input)}});
}

FloatTexture windy(const MakingNumber& m) {
    return FloatTexture(FloatKind{WindyKind{{m.input.to_texture()}}});
}

SpectrumTexture marble(const MakingSpectrum& m) {
    return SpectrumTexture(SpectrumKind{MarbleKind{{m.input.to_texture()},
                                                   octaves_of(m.input),
                                                   m.input.real("scale", 1),
                                                   m.input.real("variation", 0.2)}});
}

template <class T>
T ptex(const Making<T>& m) {
    m.input.statement.ignore_all();
    m.log.warn(m.input.statement.where, "textures of class \"ptex\" are not read: they are 0.5");
    if constexpr (std::is_same_v<T, FloatTexture>)
        return 0.5F;
    else
        return Spectrum::constant(0.5F);
}

constexpr TexturePart own(std::string_view name, float fallback) {
    return {name, fallback, false};
}

constexpr TexturePart number(std::string_view name, float fallback) {
    return {name, fallback, true};
}

constexpr std::array kConstantParts = {own("value", 1)};
constexpr std::array kScaleParts = {own("tex", 1), number("scale", 1)};
constexpr std::array kMixParts = {own("tex1", 0), own("tex2", 1), number("amount", 0.5F)};
constexpr std::array kDirectionMixParts = {own("tex1", 0), own("tex2", 1)};
constexpr std::array kCheckerboardParts = {own("tex1", 1), own("tex2", 0)};
constexpr std::array kDotsParts = {own("inside", 1), own("outside", 0)};
constexpr std::array kBilerpParts = {own("v00", 0), own("v01", 1), own("v10", 0), own("v11", 1)};

struct Row {
    std::string_view word;
    FloatTexture (*number)(const MakingNumber&);         // null: there is none
    SpectrumTexture (*spectrum)(const MakingSpectrum&);  // likewise
    std::span<const TexturePart> parts;
    Treatment treatment;
    std::string_view read_as;  // as in WordRow
};

constexpr auto kRows = std::to_array<Row>({
    {"constant", constant<FloatTexture>, constant<SpectrumTexture>, kConstantParts, kExact,
     "`value` (1)"},
    {"scale", scale<FloatTexture>, scale<SpectrumTexture>, kScaleParts, kExact,
     "`tex` (1), `scale` (1, float)"},
    {"mix", mix<FloatTexture>, mix<SpectrumTexture>, kMixParts, kExact,
     "`tex1` (0), `tex2` (1), `amount` (0.5, float)"},
    {"directionmix", direction_mix<FloatTexture>, direction_mix<SpectrumTexture>,
     kDirectionMixParts, kExact,
     "`tex1` (0), `tex2` (1), `dir` (0 1 0): `tex1` where the surface faces along it"},
    {"checkerboard", checkerboard<FloatTexture>, checkerboard<SpectrumTexture>, kCheckerboardParts,
     kExact, "`tex1` (1), `tex2` (0), `dimension` (2 or 3)"},
    {"dots", dots<FloatTexture>, dots<SpectrumTexture>, kDotsParts, kExact,
     "`inside` (1), `outside` (0)"},
    {"bilerp", bilerp<FloatTexture>, bilerp<SpectrumTexture>, kBilerpParts, kExact,
     "`v00` (0), `v01` (1), `v10` (0), `v11` (1)"},
    {"imagemap",
     float_image,
     spectrum_image,
     {},
     kExact,
     "`filename`, `wrap` (`repeat`, `black`, `clamp`, `octahedralsphere`), `filter`, `scale` (1), "
     "`invert` (false), `encoding` (`sRGB`, `linear`, `gamma 2.2`; of PNG alone)"},
    {"fbm", fbm_texture, nullptr, {}, kExact, "`octaves` (8), `roughness` (0.5); a float"},
    {"wrinkled", wrinkled, nullptr, {}, kExact, "`octaves` (8), `roughness` (0.5); a float"},
    {"windy", windy, nullptr, {}, kExact, "a float"},
    {"marble",
     nullptr,
     marble,
     {},
     kExact,
     "`octaves` (8), `roughness` (0.5), `scale` (1), `variation` (0.2); a spectrum"},
    {"ptex", ptex<FloatTexture>, ptex<SpectrumTexture>, {}, kApproximated, "0.5 everywhere"},
});

const Row& row_of(std::string_view word) {
    return *std::find_if(kRows.begin(), kRows.end(), [&](const Row& r) { return r.word == word; });
}

}  // namespace

std::span<const std::string_view> texture_classes() {
    static constexpr auto kWords = words_of(kRows);
    return kWords;
}

std::span<const WordRow> texture_words() {
    static constexpr auto kWords = word_rows("Texture", kRows);
    return kWords;
}

std::span<const TexturePart> texture_parts(std::string_view word) {
    return row_of(word).parts;
}

template <class T>
T texture_of(const TextureInput& input, const TextureParts<T>& parts, ImageTable& images,
             ImportLog& log) {
    const Statement& statement = input.statement;
    const Row& row = row_of(statement.type);
    const auto maker = [&] {
        if constexpr (std::is_same_v<T, FloatTexture>)
            return row.number;
        else
            return row.spectrum;
    }();
    if (maker == nullptr)
        throw Error(statement.where,
                    "texture " + in_quotes(statement.type) + " is not of this kind",
                    row.number == nullptr ? "make it a \"spectrum\"" : "make it a \"float\"");
    T texture = maker({input, parts, images, log});
    log.warn_unused(statement);
    return texture;
}

template FloatTexture texture_of(const TextureInput&, const TextureParts<FloatTexture>&,
                                 ImageTable&, ImportLog&);
template SpectrumTexture texture_of(const TextureInput&, const TextureParts<SpectrumTexture>&,
                                    ImageTable&, ImportLog&);

}  // namespace sunfleck::engine
