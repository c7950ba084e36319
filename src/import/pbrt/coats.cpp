// Coats by their parameters.
#include "import/pbrt/coats.h"

#include "import/pbrt/even_textures.h"
#include "import/pbrt/words.h"

namespace sunfleck::engine {
namespace {

/// The index of a coat: one for all wavelengths, the mean as the eye weighs them.
float coat_index(const Statement& statement, const CoatWords& words, Assets& assets) {
    const std::string name = words.prefix + "eta";
    const Parameter* found = statement.find(name);
    if (!found) return words.eta;
    float eta = 0;
    if (found->type == ParameterType::real) {
        eta = static_cast<float>(statement.real(name, 1.5));
    } else {
        eta = assets.spectra.curve(*found, SpectrumUse::index).luminance();  // its mean
        assets.log.warn(found->where, "a coat bends all wavelengths alike, by their mean index");
    }
    if (eta > 0) return eta;
    throw Error(found->where, "an index of refraction that is not positive",
                "use 1.5 for varnish, or another number above 0");
}

}  // namespace

std::shared_ptr<const Coat> coat_of(const Statement& statement, const CoatWords& words,
                                    Assets& assets) {
    const auto length = [&](const std::string& name, double fallback) {
        const float value =
            even_number(statement, name, assets).value_or(static_cast<float>(fallback));
        if (value >= 0) return value;
        throw Error(statement.find(name)->where, in_quotes(name) + " is negative", "use 0 or more");
    };
    const std::string& prefix = words.prefix;
    const float both = length(prefix + "roughness", 0);
    Vec2 alphas(length(prefix + "uroughness", static_cast<double>(both)),
                length(prefix + "vroughness", static_cast<double>(both)));
    if (statement.flag("remaproughness", true))
        alphas = {alpha_from_roughness(alphas.x), alpha_from_roughness(alphas.y)};
    std::optional<Ggx> facets;
    if (std::max(alphas.x, alphas.y) >= kSmoothAlpha)
        facets = Ggx{std::max(alphas.x, 1e-4F), std::max(alphas.y, 1e-4F)};
    const auto albedo =
        assets.textures.find_spectrum(statement, "albedo", SpectrumUse::reflectance);
    if (albedo && !(albedo->is_constant() && albedo->curve().luminance() <= 0))
        assets.log.warn(statement.find("albedo")->where,
                        "a coat scatters no light within it: its \"albedo\" is ignored");
    statement.ignore({"g", "maxdepth", "nsamples"});
    return std::make_shared<Coat>(coat_index(statement, words, assets), facets,
                                  length(prefix + "thickness", words.thickness));
}

}  // namespace sunfleck::engine
