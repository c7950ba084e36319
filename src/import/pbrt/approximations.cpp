// Approximated materials, each with one warning.
#include "import/pbrt/approximations.h"

#include "core/file_content.h"
#include "import/pbrt/even_textures.h"
#include "import/pbrt/measured.h"
#include "import/pbrt/words.h"
#include "material/fibre_albedo.h"

#include <algorithm>
#include <functional>

namespace sunfleck::engine {
namespace {

constexpr float kGlossyAlpha = 0.5F;  // rougher measured materials are approximated as diffuse

void warn_approximated(const Statement& statement, const std::string& instead, Assets& assets) {
    assets.log.warn(statement.where,
                    "material " + in_quotes(statement.type) + " is not simulated: " + instead);
}

/// Returns the absorption per radius. Eumelanin and pheomelanin: d'Eon et al., An Energy-Conserving
/// Hair Reflectance Model (2011), with the numbers of pbrt-v4; brown hair by default.
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

}  // namespace

Material approximate_hair(const Statement& statement, Assets& assets) {
    warn_approximated(statement, "each fibre reflects and transmits diffusely instead", assets);
    const float eta = positive_eta(statement, 1.55F, assets);
    const float beta = even_number(statement, "beta_n", assets).value_or(0.3F);
    statement.ignore({"beta_m", "alpha"});
    const Spectrum absorption = hair_absorption(statement, std::clamp(beta, 0.01F, 1.0F), assets);
    const auto fibre = [&](float nm) { return fibre_albedo(std::max(0.0F, absorption(nm)), eta); };
    return DiffuseTransmissionMaterial{tabulated([&](float nm) { return fibre(nm).back; }),
                                       tabulated([&](float nm) { return fibre(nm).through; })};
}

Material approximate_measured(const Statement& statement, Assets& assets) {
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
    warn_approximated(statement,
                      glossy ? "a metal of its mean colour and similar roughness is used"
                             : "a diffuse material of its mean reflectance is used",
                      assets);
    if (!glossy) return DiffuseMaterial{measured.albedo};
    ConductorMaterial metal;
    metal.reflectance = measured.albedo;
    metal.roughness = {measured.alpha, measured.alpha, false};
    return metal;
}

}  // namespace sunfleck::engine
