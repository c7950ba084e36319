// Means over the disc, by the powers of the darkening polynomial.
#include "sky/sun_disc.h"

#include "sky/curves.h"

namespace sunfleck::engine {
namespace {

constexpr double kRadius = 0.255;  // degrees

}  // namespace

SkyCurve sun_irradiance(const SkyModel& model, double elevation) {
    const auto darkening = SkyModel::limb_darkening();
    SkyCurve mean{};  // that of the cosine's power k over a disc is 2 / (k + 2)
    for (std::size_t k = 0; k < darkening.size(); ++k)
        mean = sum_of(mean, 2 / (static_cast<double>(k) + 2), darkening[k]);
    const SkyCurve radiance = product_of(model.sun(elevation), mean);
    return sum_of({}, 2 * kPiDouble * versine_of(kRadius), radiance);
}

SunLight sun_disc(const SkyModel& model, double elevation, const Vec3d& direction) {
    const SkyCurve middle = model.sun(elevation);
    const auto darkening = SkyModel::limb_darkening();
    std::array<double, 6> of_luminance{};
    for (std::size_t k = 0; k < darkening.size(); ++k) {
        const SkyCurve part = product_of(middle, darkening[k]);
        of_luminance[k] = static_cast<double>(spectrum_of(part).luminance());
    }
    SunLight sun;
    sun.curve = spectrum_of(sun_irradiance(model, elevation));
    sun.direction = direction;
    sun.versine = versine_of(kRadius);
    sun.darkening = normalised_darkening(of_luminance);
    return sun;
}

}  // namespace sunfleck::engine
