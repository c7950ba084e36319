// Products of a light's parameters, within the range of floats.
#include "import/pbrt/light_scale.h"

#include "import/pbrt/words.h"
#include "math/finite_product.h"

#include <utility>

namespace sunfleck::engine {
namespace {

double scale_of(const Statement& statement) {
    const double scale = statement.real("scale", 1);
    if (scale >= 0) return scale;
    throw Error(statement.find("scale")->where, "a light of negative \"scale\"", "use 0 or more");
}

/// A light that is black at scale one stays so, whatever its total.
double factor_by(const Statement& statement, const LightTotal& total) {
    const double wanted = statement.real(total.name, 0);
    return wanted > 0 && total.at_one > 0 ? wanted / total.at_one : 1;
}

/// Returns "I" times "scale": the given parameters that make a light bright.
std::string product_of(const Statement& statement, std::string_view total) {
    std::string product;
    for (const std::string_view name :
         {std::string_view("I"), std::string_view("L"), std::string_view("filename"),
          std::string_view("scale"), total}) {
        if (!statement.find(name)) continue;
        product += (product.empty() ? "" : " times ") + in_quotes(name);
    }
    return product;
}

}  // namespace

Spectrum scaled_emission(const Statement& statement, const Spectrum& curve, const LightTotal& total,
                         double peak) {
    const double factor = scale_of(statement) * factor_by(statement, total);
    if (auto emission = finite_product(curve, factor, peak)) return *std::move(emission);
    throw Error(statement.where,
                "the light is too bright: its emission, by " + product_of(statement, total.name) +
                    ", is no finite float",
                "keep it below 3.4e38");
}

}  // namespace sunfleck::engine
