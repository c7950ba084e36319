// Materials by their words.
#include "import/pbrt/materials.h"

#include "import/pbrt/approximations.h"
#include "import/pbrt/coats.h"
#include "import/pbrt/subsurface.h"
#include "import/pbrt/words.h"
#include "texture/kinds.h"

#include <algorithm>
#include <array>

namespace sunfleck::engine {
namespace {

constexpr float kGrey = 0.5F;  // pbrt-v4's default

FloatTexture checked_roughness(const Statement& statement, const std::string& name,
                               const FloatTexture& fallback, Assets& assets) {
    FloatTexture value = assets.textures.find_number(statement, name).value_or(fallback);
    if (!value.is_constant() || value.constant() >= 0) return value;
    throw Error(statement.find(name)->where, in_quotes(name) + " is negative", "use 0 or more");
}

/// @param prefix  of the parameter names: "" or "conductor.".
Roughness roughness_of(const Statement& statement, const std::string& prefix, Assets& assets) {
    const FloatTexture both = checked_roughness(statement, prefix + "roughness", 0, assets);
    return {checked_roughness(statement, prefix + "uroughness", both, assets),
            checked_roughness(statement, prefix + "vroughness", both, assets),
            statement.flag("remaproughness", true)};
}

/// Returns an index of refraction: "float eta" or a spectrum.
Spectrum eta_of(const Statement& statement, Assets& assets) {
    const Parameter* found = statement.find("eta");
    if (!found) return Spectrum::constant(1.5F);
    if (found->type != ParameterType::real) return assets.spectra.curve(*found, SpectrumUse::index);
    const auto eta = static_cast<float>(*statement.real("eta"));
    if (eta > 0) return Spectrum::constant(eta);
    throw Error(found->where, "an index of refraction that is not positive",
                "use 1.5 for glass, or another number above 0");
}

DiffuseMaterial diffuse_by(const Statement& statement, std::string_view name, Assets& assets) {
    const auto colour = assets.textures.find_spectrum(statement, name, SpectrumUse::reflectance);
    return {colour.value_or(Spectrum::constant(kGrey))};
}

Material diffuse(const Statement& statement, Assets& assets) {
    return diffuse_by(statement, "reflectance", assets);
}

Material dielectric(const Statement& statement, Assets& assets) {
    return DielectricMaterial{eta_of(statement, assets), roughness_of(statement, "", assets)};
}

Material thin_dielectric(const Statement& statement, Assets& assets) {
    return ThinDielectricMaterial{eta_of(statement, assets)};
}

ConductorMaterial conductor_by(const Statement& statement, const std::string& prefix,
                               Assets& assets) {
    const auto eta = assets.textures.find_spectrum(statement, prefix + "eta", SpectrumUse::index);
    const auto k = assets.textures.find_spectrum(statement, prefix + "k", SpectrumUse::index);
    ConductorMaterial metal;
    metal.eta = eta ? *eta : SpectrumTexture(*named_spectrum("metal-Cu-eta"));
    metal.k = k ? *k : SpectrumTexture(*named_spectrum("metal-Cu-k"));
    metal.reflectance =
        assets.textures.find_spectrum(statement, "reflectance", SpectrumUse::reflectance);
    if (metal.reflectance && (eta || k))
        throw Error(statement.find("reflectance")->where,
                    "a conductor with \"reflectance\" beside \"eta\" or \"k\"",
                    "give one or the other");
    metal.roughness = roughness_of(statement, prefix, assets);
    return metal;
}

Material conductor(const Statement& statement, Assets& assets) {
    return conductor_by(statement, "", assets);
}

Material interface(const Statement& statement, Assets&) {
    statement.ignore_all();
    return InterfaceMaterial{};
}

Material coated_diffuse(const Statement& statement, Assets& assets) {
    return CoatedDiffuseMaterial{diffuse_by(statement, "reflectance", assets).reflectance,
                                 coat_of(statement, {}, assets),
                                 statement.flag("compensated", false)};
}

Material coated_conductor(const Statement& statement, Assets& assets) {
    return CoatedConductorMaterial{conductor_by(statement, "conductor.", assets),
                                   coat_of(statement, {"interface."}, assets)};
}

SpectrumTexture scaled(const SpectrumTexture& texture, float factor) {
    if (texture.is_constant()) return texture.curve().scaled(factor);
    if (factor == 1) return texture;
    return SpectrumTexture(SpectrumKind{ScaledKind<SpectrumTexture>{texture, factor}});
}

Material diffuse_transmission(const Statement& statement, Assets& assets) {
    const double scale = statement.real("scale", 1);
    if (scale < 0)
        throw Error(statement.find("scale")->where, "\"scale\" is negative", "use 0 or more");
    const auto part = [&](std::string_view name) {
        const auto given = assets.textures.find_spectrum(statement, name, SpectrumUse::reflectance);
        return scaled(given.value_or(Spectrum::constant(0.25F)), static_cast<float>(scale));
    };
    return DiffuseTransmissionMaterial{part("reflectance"), part("transmittance")};
}

Material mix(const Statement& statement, Assets& assets) {
    MixMaterial result;
    result.amount = assets.textures.find_number(statement, "amount").value_or(0.5F);
    return result;
}

using Maker = Material (*)(const Statement&, Assets&);

struct Row {
    std::string_view word;
    Maker maker;
    Treatment treatment;
    std::string_view read_as;  // as in WordRow
};

constexpr auto kRows = std::to_array<Row>({
    {"diffuse", diffuse, kExact, "`reflectance` (0.5)"},
    {"dielectric", dielectric, kExact, "`eta` (1.5; a number or a spectrum), roughness"},
    {"thindielectric", thin_dielectric, kExact, "`eta`"},
    {"conductor", conductor, kExact, "`eta` and `k` (copper), or `reflectance`; roughness"},
    {"interface", interface, kExact, "nothing is there; also `\"none\"` and `\"\"`"},
    {"none", interface, kExact, "as `\"interface\"`"},
    {"", interface, kExact, "as `\"interface\"`"},
    {"coateddiffuse", coated_diffuse, kExact,
     "`reflectance`, `eta` (1.5), roughness, `thickness` (0.01): in closed form, all reflections "
     "between "
     "coat and base with them (pbrt-v4 walks at random). `albedo`, `g`: ignored, with a warning if "
     "the "
     "coat would scatter; a texture of its roughness counts as its mean, a spectrum of its "
     "index as "
     "its mean, with warnings. `compensated` (false; ours, pbrt-v4 refuses it): `reflectance` is "
     "how "
     "much of the light that has entered leaves again, so that what a rough coat loses is given "
     "back"},
    {"coatedconductor", coated_conductor, kExact,
     "`conductor.eta`, `conductor.k` or `reflectance`, `conductor.roughness`; `interface.eta`, "
     "`interface.roughness`, `interface.thickness`: in closed form, exact where both are smooth, "
     "else "
     "without spreading of further inner reflections; the rest as for `coateddiffuse`"},
    {"mix", mix, kExact,
     "`materials`, `amount` (0.5, a number or a texture): a ray meets one of them, by a hash of "
     "the "
     "place; with `interface` in it, the other part everywhere, with a warning"},
    {"diffusetransmission", diffuse_transmission, kExact,
     "`reflectance`, `transmittance` (0.25 each), `scale`; where both add up to more than 1 they "
     "are "
     "scaled down"},
    {"hair", approximate_hair, kApproximated,
     "`sigma_a`, `reflectance` or `color`, `eumelanin`, `pheomelanin` (1.3, 0), `eta` (1.55), "
     "`beta_n`: "
     "each fibre spreads evenly what it reflects, and through it what it lets through, in the "
     "shares "
     "that pbrt-v4's lobes have (of light from everywhere). On `\"cylinder\"` curves light goes "
     "through "
     "two walls"},
    {"subsurface", subsurface_material, kApproximated,
     "`reflectance`, or `sigma_a` and `sigma_s` with `g`, or `name`; `eta` (1.33), roughness: "
     "diffuse under its surface, with the whole reflectance of pbrt-v4's beam diffusion; light"
     " comes out where it went in, and `mfp` and `scale` say nothing. With `--subsurface walk`"
     " the shape is full of a medium of these coefficients times `scale` (1); a `reflectance` "
     "becomes the albedo of single scattering that has it, with `mfp` (1) times `scale`"},
    {"measured", approximate_measured, kApproximated,
     "`filename`: metal of its mean reflectance and of the roughness of its facets, or diffuse "
     "where "
     "that is above 0.5"},
});

}  // namespace

std::span<const std::string_view> material_types() {
    static constexpr auto kWords = words_of(kRows);
    return kWords;
}

std::span<const WordRow> material_words() {
    static constexpr auto kWords = word_rows("Material", kRows);
    return kWords;
}

Material material_of(const Statement& statement, Assets& assets) {
    const Row& row = *std::find_if(kRows.begin(), kRows.end(),
                                   [&](const Row& r) { return r.word == statement.type; });
    return row.maker(statement, assets);
}

BumpMap bump_map_of(const Statement& statement, Assets& assets) {
    const auto displacement = assets.textures.find_number(statement, "displacement");
    const auto map = statement.text("normalmap");
    if (map && !map->empty()) {
        const Encoding linear{Encoding::Kind::linear, 1};
        return NormalMap{assets.images.enter(*map, linear, statement.find("normalmap")->where)};
    }
    if (displacement && !displacement->is_constant()) return DisplacementMap{*displacement};
    return {};
}

}  // namespace sunfleck::engine
