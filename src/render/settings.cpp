// The text that says whether two renders may be merged: one "name=value" a line.
#include "render/settings.h"

#include <fmt/format.h>

namespace sunfleck {

std::string RenderSettings::text() const {
    const auto optional_number = [](const auto& value) {
        return value ? fmt::format("{}", *value) : std::string("default");
    };
    return fmt::format(
        "integrator={}\nphoton_sampler={}\ndirect={}\nmax_depth={}\nphotons_per_pass={}\n"
        "radius_pixels={}\nradius={}\nalpha={}\n",
        integrator == Integrator::sppm ? "sppm" : "path",
        photon.sampler == UniformKind::uniform ? "uniform" : "random",
        transport.direct == DirectLight::sampled ? "sampled" : "photons", transport.max_depth,
        optional_number(photon.paths_per_pass), eye.radius_pixels, optional_number(eye.radius),
        alpha);
}

}  // namespace sunfleck
