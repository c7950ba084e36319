// Parameters of sun and sky.
#include "import/pbrt/sky_lights.h"

#include "import/pbrt/light_directions.h"
#include "import/pbrt/light_images.h"
#include "import/pbrt/light_scale.h"
#include "import/pbrt/reading.h"
#include "sky/daylight.h"

#include <fmt/format.h>

namespace sunfleck::engine {
namespace {

/// Returns a number within bounds, which are part of the range.
double bounded(const Statement& statement, std::string_view name, double fallback, double low,
               double high) {
    const double value = statement.real(name, fallback);
    if (value >= low && value <= high) return value;
    throw Error(statement.find(name)->where,
                fmt::format("\"{}\" is {:g}, and not from {:g} to {:g}", name, value, low, high),
                fmt::format("use {:g}, for example", fallback));
}

}  // namespace

Light sun_light(const Statement& statement, Reading& reading) {
    constexpr double kLeast = 1e-3;  // degrees: a thousandth of the difference to a point is left
    SunLight sun;
    sun.curve =
        scaled_emission(statement, emission_of(statement, "L", reading), {"illuminance", 1});
    sun.direction = direction_of(statement, reading.still_matrix(statement.where));
    sun.versine = versine_of(bounded(statement, "angle", 0.53, kLeast, 180) / 2);
    return sun;
}

std::vector<Light> sky_lights(const Statement& statement, Reading& reading) {
    Daylight daylight;
    daylight.sun.azimuth = bounded(statement, "azimuth", daylight.sun.azimuth, -360, 360);
    daylight.sun.elevation = bounded(statement, "elevation", daylight.sun.elevation, 0, 90);
    daylight.turbidity = bounded(statement, "turbidity", daylight.turbidity, 1, 10);
    daylight.ground_albedo = bounded(statement, "groundalbedo", daylight.ground_albedo, 0, 1);
    DaylightLights lights = lights_of(daylight, turn_of(statement, reading));
    lights.sky.curve = scaled_emission(statement, lights.sky.curve, {}, lights.sky.image->peak());
    lights.sun.curve = scaled_emission(statement, lights.sun.curve, {});
    return {std::move(lights.sky), std::move(lights.sun)};
}

}  // namespace sunfleck::engine
