// Media by their names, with the coefficients of those of one colour.
#include "import/pbrt/medium_table.h"

#include "import/pbrt/data_substances.h"
#include "import/pbrt/data_vocabulary.h"
#include "import/pbrt/medium_colours.h"
#include "import/pbrt/medium_densities.h"
#include "import/pbrt/medium_glow.h"
#include "import/pbrt/version3.h"
#include "import/pbrt/words.h"
#include "math/finite_product.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunfleck::engine {
namespace {

constexpr auto kTypes = words_of(kMediumWords);

/// Returns absorption and scattering, per unit of length where the density is one.
std::pair<Spectrum, Spectrum> coefficients_of(const Statement& medium, SpectrumReader& spectra) {
    if (const auto preset = medium.text("preset"); preset && !preset->empty()) {
        const Substance& substance = substance_of(*preset, medium.find("preset")->where);
        return {Spectrum::rgb_unbounded(substance.absorption),
                Spectrum::rgb_unbounded(substance.scattering)};
    }
    const auto curve = [&](std::string_view name) {
        return spectra.find(medium, name, SpectrumUse::unbounded)
            .value_or(Spectrum::constant(1));  // pbrt-v4's default
    };
    return {curve("sigma_a"), curve("sigma_s")};
}

/// Returns a medium of one colour, without "scale" and "g".
Medium usual_medium(const Statement& medium, const Matrix& to_world, Assets& assets) {
    const auto [absorption, scattering] = coefficients_of(medium, assets.spectra);
    const auto density = density_of(medium, to_world, assets.files);
    return {absorption, scattering, 0, density, glow_of(medium, density, to_world, assets)};
}

}  // namespace

/// Returns the medium, and warns of what is not simulated.
Medium MediumTable::medium_of(const std::string& name, const Made& made, Assets& assets) {
    const Statement& medium = made.statement;
    ImportLog& log = assets.log;
    const auto warn = [&](const std::string& what) {
        log.warn(medium.where, "medium " + in_quotes(name) + " " + what);
    };
    const std::string type = *medium.text("type");
    log.count_word(medium.keyword, type);
    Medium made_of = type == "rgbgrid" ? medium_of_colours(medium, made.to_world, log)
                                       : usual_medium(medium, made.to_world, assets);
    const double scale = medium.real("scale", 1);
    if (!(scale >= 0))
        throw Error(medium.find("scale")->where, "\"scale\" is negative", "use 0 or more");
    const double g = medium.real("g", 0);
    if (!(std::abs(g) < 1))
        throw Error(medium.find("g")->where, "\"g\" is not between -1 and 1",
                    "use the mean cosine of scattering: 0 for all directions alike, up to 0.99");
    log.warn_unused(medium);
    const double peak = made_of.density ? static_cast<double>(greatest(*made_of.density)) : 1;
    const auto scaled = [&](const Spectrum& curve, const char* word) {
        if (auto product = finite_product(curve, scale, peak)) return *std::move(product);
        throw Error(medium.where,
                    "medium " + in_quotes(name) + " is too dense: " + in_quotes(word) +
                        " times \"scale\" is no finite float",
                    "keep the product below 3.4e38");
    };
    made_of.absorption = scaled(made_of.absorption, "sigma_a");
    made_of.scattering = scaled(made_of.scattering, "sigma_s");
    made_of.g = static_cast<float>(g);
    if (made_of.glow && !emits(made_of))
        warn("emits nothing, since it absorbs nothing: give it a \"sigma_a\"");
    return made_of;
}

const Substance& substance_of(const std::string& name, const SourceLocation& from) {
    const auto* const row = std::find_if(kSubstances.begin(), kSubstances.end(),
                                         [&](const Substance& s) { return s.word == name; });
    if (row != kSubstances.end()) return *row;
    throw Error(from, "unknown substance " + in_quotes(name),
                did_you_mean(words_of(kSubstances), name));
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved from
void MediumTable::make(Statement statement, const Matrix& to_world) {
    const auto type = statement.text("type");
    if (!type)
        throw Error(statement.where, "medium " + in_quotes(statement.type) + " has no type",
                    "add \"string type\" \"homogeneous\"");
    check_not_of_v3(statement.keyword, *type, statement.where);
    if (std::find(kTypes.begin(), kTypes.end(), *type) == kTypes.end())
        throw Error(statement.where, "unknown medium " + in_quotes(*type),
                    use_one_of(kTypes, *type));
    const SourceLocation where = statement.where;
    const std::string name = statement.type;
    if (!made_.try_emplace(name, Made{std::move(statement), to_world}).second)
        throw Error(where, "a second medium " + in_quotes(name), "give it another name");
}

MediumNumber MediumTable::number_of(const std::string& name, const SourceLocation& from) {
    if (name.empty()) return 0;
    const auto next = static_cast<MediumNumber>(uses_.size() + 1);
    const auto [place, is_new] = numbers_.try_emplace(name, next);
    if (is_new) uses_.push_back({name, from});
    return place->second;
}

void MediumTable::finish(Assets& assets, Media& media) const {
    for (const Use& use : uses_) {
        const auto found = made_.find(use.name);
        if (found == made_.end())
            throw Error(
                use.from, "there is no medium " + in_quotes(use.name),
                "make the medium, or name another: " + did_you_mean(names_of(made_), use.name));
        media.all.push_back(medium_of(use.name, found->second, assets));
    }
}

}  // namespace sunfleck::engine
