// Coefficients of what is below a surface, and their total albedo.
#include "import/pbrt/subsurface.h"

#include "import/pbrt/coats.h"
#include "import/pbrt/data_substances.h"
#include "import/pbrt/even_textures.h"
#include "import/pbrt/medium_table.h"
#include "import/pbrt/words.h"
#include "material/subsurface_albedo.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// Coefficients per millimetre, or whatever the unit of "scale" is.
struct Coefficients {
    Spectrum scattering;
    Spectrum absorption;

    /// Returns the albedo of single scattering at a wavelength.
    float albedo(float nm) const {
        const float scattered = std::max(0.0F, scattering(nm));
        const float all = scattered + std::max(0.0F, absorption(nm));
        return all > 0 ? scattered / all : 0;
    }
};

Coefficients coefficients_of(const Statement& statement, Assets& assets) {
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

/// Returns whether the medium is told by its total albedo.
bool is_by_reflectance(const Statement& statement) {
    return statement.find("reflectance") != nullptr && statement.find("name") == nullptr &&
           statement.find("sigma_a") == nullptr;
}

double bend_of(const Statement& statement) {
    const double g = statement.real("g", 0);
    if (g > -1 && g < 1) return g;
    throw Error(statement.find("g")->where, "\"g\" is not in (-1, 1)", "use 0 for even scattering");
}

/// Returns the single-scattering albedo with a total albedo, by bisection: it grows with it.
float single_albedo(const SubsurfaceAlbedo& whole, float total) {
    float low = 0;
    float high = 1;
    for (int i = 0; i < 30; ++i) {
        const float middle = (low + high) / 2;
        (whole(middle) < total ? low : high) = middle;
    }
    return high;
}

Material dielectric_of(const Coat& coat) {
    DielectricMaterial surface;
    surface.eta = Spectrum::constant(coat.eta());
    if (coat.facets()) surface.roughness = {coat.facets()->alpha_x, coat.facets()->alpha_y, false};
    return surface;
}

}  // namespace

Material subsurface_material(const Statement& statement, Assets& assets) {
    const double g = bend_of(statement);
    statement.ignore({"mfp", "scale"});
    const auto coat = coat_of(statement, {"", 1.33F, 0}, assets);
    if (assets.subsurface == SubsurfaceRule::walked) {
        statement.ignore({"reflectance", "name", "sigma_a", "sigma_s"});  // medium_below()
        return dielectric_of(*coat);
    }
    assets.log.warn(statement.where, "material " + in_quotes(statement.type) +
                                         " is not simulated: a coated diffuse material of the same "
                                         "albedo is used (--subsurface walk simulates it)");
    const auto reflectance =
        assets.textures.find_spectrum(statement, "reflectance", SpectrumUse::reflectance);
    if (is_by_reflectance(statement)) return CoatedDiffuseMaterial{*reflectance, coat, true};
    const Coefficients below = coefficients_of(statement, assets);
    const bool by_name = statement.find("name") != nullptr;
    const SubsurfaceAlbedo whole(coat->eta(), by_name ? 0 : static_cast<float>(g));
    return CoatedDiffuseMaterial{tabulated([&](float nm) { return whole(below.albedo(nm)); }), coat,
                                 true};
}

Medium medium_below(const Statement& statement, Assets& assets) {
    const double scale = statement.real("scale", 1);
    if (!(scale > 0))
        throw Error(statement.find("scale")->where, "\"scale\" is not positive",
                    "use the number of millimetres of a unit, or 1");
    const auto g = static_cast<float>(bend_of(statement));
    const auto times = static_cast<float>(scale);
    if (!is_by_reflectance(statement)) {
        const Coefficients below = coefficients_of(statement, assets);
        return {below.absorption.scaled(times), below.scattering.scaled(times),
                statement.find("name") != nullptr ? 0 : g};
    }
    const float eta = coat_of(statement, {"", 1.33F, 0}, assets)->eta();
    const Spectrum total = *even_curve(statement, "reflectance", SpectrumUse::reflectance, assets);
    const Spectrum free = even_curve(statement, "mfp", SpectrumUse::unbounded, assets)
                              .value_or(Spectrum::constant(1));
    const SubsurfaceAlbedo whole(eta, g);
    const auto coefficient = [&](float nm, bool scatters) {
        const float single = single_albedo(whole, std::clamp(total(nm), 0.0F, 1.0F));
        const float events = 1 / std::max(1e-6F, free(nm) * times);
        return events * (scatters ? single : 1 - single);
    };
    return {tabulated([&](float nm) { return coefficient(nm, false); }),
            tabulated([&](float nm) { return coefficient(nm, true); }), g};
}

}  // namespace sunfleck::engine
