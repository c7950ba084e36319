// Stand-ins, each told in one warning.
#include "import/pbrt/stand_ins.h"

#include "core/file_content.h"
#include "import/pbrt/coats.h"
#include "import/pbrt/data_substances.h"
#include "import/pbrt/even_textures.h"
#include "import/pbrt/measured.h"
#include "import/pbrt/words.h"
#include "material/fibre_albedo.h"
#include "material/subsurface_albedo.h"

#include <algorithm>
#include <functional>

namespace sunfleck::engine {
namespace {

constexpr float kGlossyAlpha = 0.5F;  // rougher measured materials are diffuse

void warn_stand_in(const Statement& statement, const std::string& instead, Assets& assets) {
    assets.log.warn(statement.where,
                    "material " + in_quotes(statement.type) + " is not simulated: " + instead);
}

/// Per radius. Eumelanin and pheomelanin: d'Eon et al., An Energy-Conserving Hair Reflectance Model
/// (2011), in the numbers of pbrt-v4; of brown hair where nothing is said.
Spectrum hair_absorption(const Statement& statement, float beta, Assets& assets) {
    const auto given = even_curve(statement, "sigma_a", SpectrumUse::unbounded, assets);
    auto colour = even_curve(statement, "reflectance", SpectrumUse::reflectance, assets);
    if (!colour) colour = even_curve(statement, "color", SpectrumUse::reflectance, assets);
    const auto dark = even_number(statement, "eumelanin", assets);
    const auto red = even_number(statement, "pheomelanin", assets);
    if (given) return *given;
    if (colour)
        return tabulated([&](float nm) {
            return absorption_of_hair(std::clamp((*colour)(nm), 1e-4F, 1.0F), beta);
        });
    const float some = dark || red ? 0 : 1.3F;
    return Spectrum::rgb_unbounded(Vec3(0.419F, 0.697F, 1.37F) *
                                       std::max(0.0F, dark.value_or(some)) +
                                   Vec3(0.187F, 0.4F, 1.05F) * std::max(0.0F, red.value_or(0)));
}

float positive_eta(const Statement& statement, float fallback, Assets& assets) {
    const float eta = even_number(statement, "eta", assets).value_or(fallback);
    if (eta > 0) return eta;
    throw Error(statement.find("eta")->where, "an index of refraction that is not positive",
                "use 1.55 for hair, 1.33 for skin, or another number above 0");
}

/// Scattering over extinction, without what is scattered straight on, for one wavelength.
struct Cloudiness {
    Spectrum scattering;
    Spectrum absorption;

    float albedo(float nm) const {
        const float scattered = std::max(0.0F, scattering(nm));
        const float all = scattered + std::max(0.0F, absorption(nm));
        return all > 0 ? scattered / all : 0;
    }
};

Cloudiness cloudiness_of(const Statement& statement, Assets& assets) {
    const auto absorption = even_curve(statement, "sigma_a", SpectrumUse::unbounded, assets);
    const auto scattering = even_curve(statement, "sigma_s", SpectrumUse::unbounded, assets);
    if (const auto name = statement.text("name"); name && !name->empty()) {
        const Substance& substance = substance_of(*name, statement.find("name")->where);
        return {Spectrum::rgb_unbounded(substance.scattering),
                Spectrum::rgb_unbounded(substance.absorption)};
    }
    if (absorption.has_value() != scattering.has_value())
        throw Error(statement.where, "a \"subsurface\" with one of \"sigma_a\" and \"sigma_s\"",
                    "give both, or \"reflectance\"");
    if (absorption) return {*scattering, *absorption};
    const Substance& milk = substance_of("Wholemilk", statement.where);  // nearly pbrt-v4's
    return {Spectrum::rgb_unbounded(milk.scattering),
            Spectrum::rgb_unbounded({0.0011F, 0.0024F, 0.014F})};
}

}  // namespace

Material hair_stand_in(const Statement& statement, Assets& assets) {
    warn_stand_in(statement, "each fibre spreads evenly what it reflects, and what it lets through",
                  assets);
    const float eta = positive_eta(statement, 1.55F, assets);
    const float beta = even_number(statement, "beta_n", assets).value_or(0.3F);
    statement.ignore({"beta_m", "alpha"});
    const Spectrum absorption = hair_absorption(statement, std::clamp(beta, 0.01F, 1.0F), assets);
    const auto fibre = [&](float nm) { return fibre_albedo(std::max(0.0F, absorption(nm)), eta); };
    return DiffuseTransmissionMaterial{tabulated([&](float nm) { return fibre(nm).back; }),
                                       tabulated([&](float nm) { return fibre(nm).through; })};
}

Material subsurface_stand_in(const Statement& statement, Assets& assets) {
    warn_stand_in(statement, "light comes out where it went in, as much as should", assets);
    const double g = statement.real("g", 0);
    if (!(g > -1 && g < 1))
        throw Error(statement.find("g")->where, "\"g\" is not in (-1, 1)",
                    "use 0 for even scattering");
    statement.ignore({"mfp", "scale"});
    const auto coat = coat_of(statement, {"", 1.33F, 0}, assets);
    const auto reflectance =
        assets.textures.find_spectrum(statement, "reflectance", SpectrumUse::reflectance);
    const bool by_name = statement.find("name") != nullptr;
    const bool by_sigmas = statement.find("sigma_a") != nullptr;
    if (reflectance && !by_name && !by_sigmas)
        return CoatedDiffuseMaterial{*reflectance, coat, true};
    const Cloudiness cloud = cloudiness_of(statement, assets);
    const SubsurfaceAlbedo whole(coat->eta(), by_name ? 0 : static_cast<float>(g));
    return CoatedDiffuseMaterial{tabulated([&](float nm) { return whole(cloud.albedo(nm)); }), coat,
                                 true};
}

Material measured_stand_in(const Statement& statement, Assets& assets) {
    const Parameter* file = statement.find("filename", ParameterType::text);
    if (!file || file->texts.size() != 1)
        throw Error(statement.where, "a measured material without a file",
                    "add \"string filename\" \"name.bsdf\"");
    const auto measured =
        assets.files.read_as(file->texts[0], file->where, [&](const NamedFile& data) {
            if (!data.bytes.starts_with("tensor_file"))
                refuse_other_content(data.bytes, data.path, "a file of measurements (.bsdf)");
            return summary_of_measured(data.bytes, file->where);
        });
    const bool glossy = measured.alpha < kGlossyAlpha;
    warn_stand_in(statement,
                  glossy ? "it is metal of its mean colour and about its roughness"
                         : "it is diffuse, with its mean reflectance",
                  assets);
    if (!glossy) return DiffuseMaterial{measured.albedo};
    ConductorMaterial metal;
    metal.reflectance = measured.albedo;
    metal.roughness = {measured.alpha, measured.alpha, false};
    return metal;
}

}  // namespace sunfleck::engine
