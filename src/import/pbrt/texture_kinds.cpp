// Classes of textures by their words, with pbrt-v4's parameters and defaults.
#include "import/pbrt/texture_kinds.h"

#include "import/pbrt/reading.h"
#include "import/pbrt/textures.h"
#include "import/pbrt/words.h"
#include "texture/kinds.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace sunfleck {
namespace {

/// What the makers of all classes need.
struct Making {
    const Statement& statement;
    const Matrix& to_world;
    SpectrumUse use;
    Reading& reading;

    Affine to_texture() const { return Placement(to_world).to_object; }
    float real(std::string_view name, double fallback) const {
        return static_cast<float>(statement.real(name, fallback));
    }
    Vec3 vector(std::string_view name, const Vec3& fallback) const {
        const Parameter* found = statement.find(name, ParameterType::vector3);
        if (!found) return fallback;
        if (found->numbers.size() != 3)
            throw Error(found->where, "parameter " + found->title() + " is no vector", "give 3");
        return {Vec3d(found->numbers[0], found->numbers[1], found->numbers[2])};
    }
    /// A word out of a list; its first one where there is none.
    std::size_t choice(std::string_view name, std::span<const std::string_view> words) const {
        const std::string word = statement.text(name).value_or(std::string(words[0]));
        const auto found = std::find(words.begin(), words.end(), word);
        if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
        throw Error(statement.find(name)->where,
                    "unknown " + in_quotes(name) + " " + in_quotes(word), use_one_of(words, word));
    }

    /// A parameter of the sort of the texture itself.
    template <class T>
    T part(std::string_view name, float fallback) const {
        if constexpr (std::is_same_v<T, FloatTexture>) {
            return number(name, fallback);
        } else {
            const auto found = find_spectrum_texture(statement, name, use, reading);
            return found ? *found : T(SpectralCurve::constant(fallback));
        }
    }
    FloatTexture number(std::string_view name, float fallback) const {
        return find_float_texture(statement, name, reading).value_or(fallback);
    }
};

Mapping mapping_of(const Making& m) {
    static constexpr std::array<std::string_view, 4> kWords = {"uv", "spherical", "cylindrical",
                                                               "planar"};
    const std::size_t kind = m.choice("mapping", kWords);
    if (kind == 1) return SphericalMapping{m.to_texture()};
    if (kind == 2) return CylindricalMapping{m.to_texture()};
    const Vec2 shift(m.real("udelta", 0), m.real("vdelta", 0));
    if (kind == 3)
        return PlanarMapping{m.to_texture(), m.vector("v1", {1, 0, 0}), m.vector("v2", {0, 1, 0}),
                             shift};
    return UvMapping{{m.real("uscale", 1), m.real("vscale", 1)}, shift};
}

Octaves octaves_of(const Making& m) {
    constexpr int kMost = 32;  // beyond it a float has no finer scale
    return {std::clamp(m.statement.integer("octaves").value_or(8), 0, kMost),
            m.real("roughness", 0.5)};
}

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
T constant(const Making& m) {
    return m.part<T>("value", 1);
}

template <class T>
T scale(const Making& m) {
    return T(Kind<T>{ScaledKind<T>{m.part<T>("tex", 1), m.number("scale", 1)}});
}

template <class T>
T mix(const Making& m) {
    return T(
        Kind<T>{MixKind<T>{m.part<T>("tex1", 0), m.part<T>("tex2", 1), m.number("amount", 0.5F)}});
}

template <class T>
T direction_mix(const Making& m) {
    const Vec3d direction = Affine(m.to_world).vector(Vec3d(m.vector("dir", {0, 1, 0})));
    return T(Kind<T>{DirectionMixKind<T>{m.part<T>("tex1", 0), m.part<T>("tex2", 1),
                                         Vec3(direction.normalized())}});
}

template <class T>
T checkerboard(const Making& m) {
    const int dimension = m.statement.integer("dimension").value_or(2);
    if (dimension != 2 && dimension != 3)
        throw Error(m.statement.find("dimension")->where,
                    "a checkerboard of " + std::to_string(dimension) + " dimensions", "use 2 or 3");
    CheckerboardKind<T> kind{mapping_of(m), m.part<T>("tex1", 1), m.part<T>("tex2", 0)};
    if (dimension == 3) kind.mapping = PointMapping{m.to_texture()};
    return T(Kind<T>{std::move(kind)});
}

template <class T>
T dots(const Making& m) {
    return T(Kind<T>{DotsKind<T>{mapping_of(m), m.part<T>("inside", 1), m.part<T>("outside", 0)}});
}

template <class T>
T bilerp(const Making& m) {
    return T(Kind<T>{BilerpKind<T>{mapping_of(m), m.part<T>("v00", 0), m.part<T>("v01", 1),
                                   m.part<T>("v10", 0), m.part<T>("v11", 1)}});
}

Encoding encoding_of(const Making& m) {
    const std::string word = m.statement.text("encoding").value_or("sRGB");
    if (word == "sRGB") return {};
    if (word == "linear") return {Encoding::Kind::linear, 1};
    float exponent = 0;
    if (std::sscanf(word.c_str(), "gamma %f", &exponent) == 1 && exponent > 0 && exponent < 100)
        return {Encoding::Kind::gamma, exponent};
    throw Error(m.statement.find("encoding")->where, "unknown encoding " + in_quotes(word),
                "use \"sRGB\", \"linear\" or \"gamma 2.2\"");
}

ImageKind image_kind(const Making& m) {
    static constexpr std::array<std::string_view, 4> kWraps = {"repeat", "black", "clamp",
                                                               "octahedralsphere"};
    static constexpr std::array<std::string_view, 5> kFilters = {"bilinear", "point", "trilinear",
                                                                 "ewa", "EWA"};
    const Statement& statement = m.statement;
    const auto name = statement.text("filename");
    if (!name || name->empty())
        throw Error(statement.where, "an imagemap without a file", "add \"string filename\"");
    ImageKind kind;
    kind.mapping = mapping_of(m);
    kind.wrap = static_cast<Wrap>(m.choice("wrap", kWraps));
    const std::size_t filter = m.choice("filter", kFilters);
    kind.nearest = filter == 1;
    if (filter > 1)
        m.reading.warn(statement.where,
                       "images are not filtered by distance: \"trilinear\" and "
                       "\"ewa\" are as \"bilinear\"");
    kind.scale = m.real("scale", 1);
    kind.invert = statement.flag("invert", false);
    kind.image = m.reading.images.enter(*name, encoding_of(m), statement.where, m.reading);
    statement.ignore({"maxanisotropy"});
    return kind;
}

ColourUse colour_use(SpectrumUse use) {
    if (use == SpectrumUse::reflectance) return ColourUse::albedo;
    return use == SpectrumUse::emission ? ColourUse::illuminant : ColourUse::unbounded;
}

FloatTexture float_image(const Making& m) {
    return FloatTexture(FloatKind{FloatImageKind{image_kind(m)}});
}

SpectrumTexture spectrum_image(const Making& m) {
    return SpectrumTexture(SpectrumKind{SpectrumImageKind{image_kind(m), colour_use(m.use)}});
}

FloatTexture fbm_texture(const Making& m) {
    return FloatTexture(FloatKind{FbmKind{{m.to_texture()}, octaves_of(m)}});
}

FloatTexture wrinkled(const Making& m) {
    return FloatTexture(FloatKind{WrinkledKind{{m.to_texture()}, octaves_of(m)}});
}

FloatTexture windy(const Making& m) {
    return FloatTexture(FloatKind{WindyKind{{m.to_texture()}}});
}

SpectrumTexture marble(const Making& m) {
    return SpectrumTexture(SpectrumKind{
        MarbleKind{{m.to_texture()}, octaves_of(m), m.real("scale", 1), m.real("variation", 0.2)}});
}

template <class T>
T ptex(const Making& m) {
    m.statement.ignore_all();
    m.reading.warn(m.statement.where, "textures of class \"ptex\" are not read: they are 0.5");
    if constexpr (std::is_same_v<T, FloatTexture>)
        return 0.5F;
    else
        return SpectralCurve::constant(0.5F);
}

struct Row {
    std::string_view word;
    FloatTexture (*number)(const Making&);       // null: there is none
    SpectrumTexture (*spectrum)(const Making&);  // likewise
};

constexpr std::array<Row, 13> kRows = {
    {{"constant", constant<FloatTexture>, constant<SpectrumTexture>},
     {"imagemap", float_image, spectrum_image},
     {"scale", scale<FloatTexture>, scale<SpectrumTexture>},
     {"mix", mix<FloatTexture>, mix<SpectrumTexture>},
     {"directionmix", direction_mix<FloatTexture>, direction_mix<SpectrumTexture>},
     {"checkerboard", checkerboard<FloatTexture>, checkerboard<SpectrumTexture>},
     {"dots", dots<FloatTexture>, dots<SpectrumTexture>},
     {"bilerp", bilerp<FloatTexture>, bilerp<SpectrumTexture>},
     {"fbm", fbm_texture, nullptr},
     {"wrinkled", wrinkled, nullptr},
     {"windy", windy, nullptr},
     {"marble", nullptr, marble},
     {"ptex", ptex<FloatTexture>, ptex<SpectrumTexture>}}};

}  // namespace

std::span<const std::string_view> texture_classes() {
    static constexpr auto kWords = words_of(kRows);
    return kWords;
}

template <class T>
T texture_of(const Statement& statement, const Matrix& to_world, SpectrumUse use,
             Reading& reading) {
    const Row& row = *std::find_if(kRows.begin(), kRows.end(),
                                   [&](const Row& r) { return r.word == statement.type; });
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
    T texture = maker({statement, to_world, use, reading});
    reading.warn_unused(statement);
    return texture;
}

template FloatTexture texture_of(const Statement&, const Matrix&, SpectrumUse, Reading&);
template SpectrumTexture texture_of(const Statement&, const Matrix&, SpectrumUse, Reading&);

}  // namespace sunfleck
