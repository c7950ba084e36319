// A light that does not say its power cannot be chosen in proportion to it: refused.
// Refused with: constraint|LightModel
#include "light/light.h"

namespace sunfleck::engine {

struct Powerless {
    static constexpr std::string_view name = "powerless";
    static constexpr bool comes_from_afar = false;
    Spectrum curve;

    Emission sample_emission(const EmissionDimensions&, const SceneSphere&) const { return {}; }
    EmissionDimensions emission_dimensions(const LightRay&, const SceneSphere&) const { return {}; }
    double emission_pdf(const LightRay&, const SceneSphere&) const { return 0; }
    std::optional<DirectSample> sample_direct(const Vec3&, const Vec2&, const SceneSphere&) const {
        return {};
    }
#ifndef FAULT
    double power(const SceneSphere&) const {
        return 0;
    }
#endif
};

using WithPowerless = LightVariant<PointLight, Powerless>;
static_assert(std::variant_size_v<WithPowerless> == 2);

}  // namespace sunfleck::engine
