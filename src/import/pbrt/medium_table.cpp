// Media by their names, with the coefficients of homogeneous ones.
#include "import/pbrt/medium_table.h"

#include "import/pbrt/data_substances.h"
#include "import/pbrt/data_vocabulary.h"
#include "import/pbrt/medium_densities.h"
#include "import/pbrt/version3.h"
#include "import/pbrt/words.h"
#include "math/finite_product.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr auto kTypes = words_of(kMediumWords);

/// Coefficients per unit of length.
struct Coefficients {
    Spectrum absorption;
    Spectrum scattering;
};

Coefficients coefficients_of(const Statement& medium, SpectrumReader& spectra) {
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

bool is_dark(const Spectrum& curve) {
    return !(curve.luminance() > 0);
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
    if (type == "rgbgrid") {
        medium.ignore_all();
        warn("of type " + in_quotes(type) + " is not simulated: light passes it unchanged");
        return {};
    }
    const Coefficients medium_is = coefficients_of(medium, assets.spectra);
    const double scale = medium.real("scale", 1);
    if (!(scale >= 0))
        throw Error(medium.find("scale")->where, "\"scale\" is negative", "use 0 or more");
    const double g = medium.real("g", 0);
    if (!(std::abs(g) < 1))
        throw Error(medium.find("g")->where, "\"g\" is not between -1 and 1",
                    "use the mean cosine of scattering: 0 for all directions alike, up to 0.99");
    const auto density = density_of(medium, made.to_world, assets.files, log);
    const double peak = density ? static_cast<double>(greatest(*density)) : 1;
    const auto glow = assets.spectra.find(medium, "Le", SpectrumUse::unbounded);
    medium.ignore({"Lescale"});
    log.warn_unused(medium);
    if (glow && !is_dark(*glow)) warn("emits, which is not simulated: \"Le\" is ignored");
    const auto scaled = [&](const Spectrum& curve, const char* word) {
        if (auto product = finite_product(curve, scale, peak)) return *std::move(product);
        throw Error(medium.where,
                    "medium " + in_quotes(name) + " is too dense: " + in_quotes(word) +
                        " times \"scale\" is no finite float",
                    "keep the product below 3.4e38");
    };
    return {scaled(medium_is.absorption, "sigma_a"), scaled(medium_is.scattering, "sigma_s"),
            static_cast<float>(g), density};
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
