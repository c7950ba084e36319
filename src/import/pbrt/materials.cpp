// Materials by their words, and what stands in for those that we do not have.
#include "import/pbrt/materials.h"

#include "import/pbrt/coats.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/spectra.h"
#include "import/pbrt/stand_ins.h"
#include "import/pbrt/textures.h"
#include "import/pbrt/words.h"
#include "texture/kinds.h"

#include <algorithm>
#include <array>

namespace sunfleck {
namespace {

constexpr float kGrey = 0.5F;  // pbrt-v4's default
constexpr int kDeepestMix = 32;

FloatTexture checked_roughness(const Statement& statement, const std::string& name,
                               const FloatTexture& fallback, Reading& reading) {
    FloatTexture value = find_float_texture(statement, name, reading).value_or(fallback);
    if (!value.is_constant() || value.constant() >= 0) return value;
    throw Error(statement.find(name)->where, in_quotes(name) + " is negative", "use 0 or more");
}

/// @param prefix  of the names of the parameters: "" or "conductor.".
Roughness roughness_of(const Statement& statement, const std::string& prefix, Reading& reading) {
    const FloatTexture both = checked_roughness(statement, prefix + "roughness", 0, reading);
    return {checked_roughness(statement, prefix + "uroughness", both, reading),
            checked_roughness(statement, prefix + "vroughness", both, reading),
            statement.flag("remaproughness", true)};
}

/// An index of refraction: "float eta" or a spectrum.
SpectralCurve eta_of(const Statement& statement, Reading& reading) {
    const Parameter* found = statement.find("eta");
    if (!found) return SpectralCurve::constant(1.5F);
    if (found->type != ParameterType::real) return curve_of(*found, SpectrumUse::index, reading);
    const auto eta = static_cast<float>(*statement.real("eta"));
    if (eta > 0) return SpectralCurve::constant(eta);
    throw Error(found->where, "an index of refraction that is not positive",
                "use 1.5 for glass, or another number above 0");
}

DiffuseMaterial diffuse_by(const Statement& statement, std::string_view name, Reading& reading) {
    const auto colour = find_spectrum_texture(statement, name, SpectrumUse::reflectance, reading);
    return {colour.value_or(SpectralCurve::constant(kGrey))};
}

Material diffuse(const Statement& statement, Reading& reading) {
    return diffuse_by(statement, "reflectance", reading);
}

Material dielectric(const Statement& statement, Reading& reading) {
    return DielectricMaterial{eta_of(statement, reading), roughness_of(statement, "", reading)};
}

Material thin_dielectric(const Statement& statement, Reading& reading) {
    return ThinDielectricMaterial{eta_of(statement, reading)};
}

ConductorMaterial conductor_by(const Statement& statement, const std::string& prefix,
                               Reading& reading) {
    const auto eta = find_spectrum_texture(statement, prefix + "eta", SpectrumUse::index, reading);
    const auto k = find_spectrum_texture(statement, prefix + "k", SpectrumUse::index, reading);
    ConductorMaterial metal;
    metal.eta = eta ? *eta : SpectrumTexture(*named_spectrum("metal-Cu-eta"));
    metal.k = k ? *k : SpectrumTexture(*named_spectrum("metal-Cu-k"));
    metal.reflectance =
        find_spectrum_texture(statement, "reflectance", SpectrumUse::reflectance, reading);
    if (metal.reflectance && (eta || k))
        throw Error(statement.find("reflectance")->where,
                    "a conductor with \"reflectance\" beside \"eta\" or \"k\"",
                    "give one or the other");
    metal.roughness = roughness_of(statement, prefix, reading);
    return metal;
}

Material conductor(const Statement& statement, Reading& reading) {
    return conductor_by(statement, "", reading);
}

Material interface(const Statement& statement, Reading&) {
    statement.ignore_all();
    return InterfaceMaterial{};
}

Material coated_diffuse(const Statement& statement, Reading& reading) {
    return CoatedDiffuseMaterial{diffuse_by(statement, "reflectance", reading).reflectance,
                                 coat_of(statement, {}, reading)};
}

Material coated_conductor(const Statement& statement, Reading& reading) {
    return CoatedConductorMaterial{conductor_by(statement, "conductor.", reading),
                                   coat_of(statement, {"interface."}, reading)};
}

SpectrumTexture scaled(const SpectrumTexture& texture, float factor) {
    if (texture.is_constant()) return texture.curve().scaled(factor);
    if (factor == 1) return texture;
    return SpectrumTexture(SpectrumKind{ScaledKind<SpectrumTexture>{texture, factor}});
}

Material diffuse_transmission(const Statement& statement, Reading& reading) {
    const double scale = statement.real("scale", 1);
    if (scale < 0)
        throw Error(statement.find("scale")->where, "\"scale\" is negative", "use 0 or more");
    const auto part = [&](std::string_view name) {
        const auto given =
            find_spectrum_texture(statement, name, SpectrumUse::reflectance, reading);
        return scaled(given.value_or(SpectralCurve::constant(0.25F)), static_cast<float>(scale));
    };
    return DiffuseTransmissionMaterial{part("reflectance"), part("transmittance")};
}

bool is_interface(const std::string& name, const SourceLocation& where, Reading& reading) {
    if (name == "interface" || name == "none" || name.empty()) return true;
    const std::string& type = reading.materials.named(name, where).type;
    return type == "interface" || type == "none" || type.empty();
}

/// The names of both parts; what is below is looked at once. @throws Error when they mix each other
/// in a circle.
const Parameter& parts_of_mix(const Statement& statement, int depth, Reading& reading) {
    const Parameter* names = statement.find("materials", ParameterType::text);
    if (!names || names->texts.size() != 2)
        throw Error(statement.where, "a mix without two materials",
                    "add \"string materials\" [ \"one\" \"another\" ]");
    if (depth >= kDeepestMix)
        throw Error(statement.where,
                    "materials mix each other in a circle, or more than " +
                        std::to_string(kDeepestMix) + " deep",
                    "break the circle, or mix fewer");
    for (const std::string& name : names->texts) {
        if (is_interface(name, names->where, reading)) continue;
        const Statement& part = reading.materials.named(name, names->where);
        if (part.type != "mix" || reading.sound_mixes.contains(&part)) continue;
        parts_of_mix(part, depth + 1, reading);
        reading.sound_mixes.insert(&part);
    }
    return *names;
}

/// Where nothing is mixed in, the other part is everywhere.
Material mix(const Statement& statement, Reading& reading) {
    const Parameter& names = parts_of_mix(statement, 0, reading);
    MixMaterial result;
    result.amount = find_float_texture(statement, "amount", reading).value_or(0.5F);
    std::vector<std::string> there;
    for (const std::string& name : names.texts)
        if (!is_interface(name, names.where, reading)) there.push_back(name);
    if (there.size() < 2)
        reading.warn(statement.where,
                     "a mix with nothing in it is not simulated: it is the other part everywhere");
    if (there.empty()) return InterfaceMaterial{};
    for (std::size_t i = 0; i < 2; ++i) {
        result.parts.at(i) =
            reading.materials.slot_of(there.at(std::min(i, there.size() - 1)), names.where);
        reading.materials.use(result.parts.at(i));
    }
    return result;
}

using Maker = Material (*)(const Statement&, Reading&);

struct Row {
    std::string_view word;
    Maker maker;
};

constexpr std::array<Row, 14> kRows = {{{"diffuse", diffuse},
                                        {"dielectric", dielectric},
                                        {"thindielectric", thin_dielectric},
                                        {"conductor", conductor},
                                        {"interface", interface},
                                        {"none", interface},
                                        {"", interface},
                                        {"coateddiffuse", coated_diffuse},
                                        {"coatedconductor", coated_conductor},
                                        {"mix", mix},
                                        {"measured", measured_stand_in},
                                        {"hair", hair_stand_in},
                                        {"subsurface", subsurface_stand_in},
                                        {"diffusetransmission", diffuse_transmission}}};

}  // namespace

std::span<const std::string_view> material_types() {
    static constexpr auto kWords = words_of(kRows);
    return kWords;
}

Material material_of(const Statement& statement, Reading& reading) {
    const Row& row = *std::find_if(kRows.begin(), kRows.end(),
                                   [&](const Row& r) { return r.word == statement.type; });
    return row.maker(statement, reading);
}

Relief relief_of(const Statement& statement, Reading& reading) {
    const auto displacement = find_float_texture(statement, "displacement", reading);
    const auto map = statement.text("normalmap");
    if (map && !map->empty()) {
        const Encoding linear{Encoding::Kind::linear, 1};
        return NormalMap{
            reading.images.enter(*map, linear, statement.find("normalmap")->where, reading)};
    }
    if (displacement && !displacement->is_constant()) return Bumps{*displacement};
    return {};
}

}  // namespace sunfleck
