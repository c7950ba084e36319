// The sky's mean spectrum, and the colours of directions relative to it.
#include "sky/daylight.h"

#include "core/parallel.h"
#include "math/warp.h"
#include "scene/additions.h"
#include "sky/curves.h"
#include "sky/sun_disc.h"

#include <algorithm>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kSide = 1024;  // of the map: texels of a fifth of a degree
constexpr std::size_t kMeanSide = 64;

/// Returns the direction in the middle of a texel.
Vec3d texel_direction(std::size_t x, std::size_t y, std::size_t side) {
    const auto place = [&](std::size_t i) {
        return (static_cast<double>(i) + 0.5) / static_cast<double>(side);
    };
    return uniform_sphere({place(x), place(y)});
}

struct DomeMeans {
    SkyCurve radiance{};
    SkyCurve irradiance{};  // on the ground
};

DomeMeans means_of(const SkyModel& model, const Vec3d& to_sun) {
    DomeMeans means;
    int count = 0;
    for (std::size_t y = 0; y < kMeanSide; ++y)
        for (std::size_t x = 0; x < kMeanSide; ++x) {
            const Vec3d w = texel_direction(x, y, kMeanSide);
            if (!(w.z > 0)) continue;
            const SkyCurve from_there = model.sky(w.z, w.dot(to_sun));
            means.radiance = sum_of(means.radiance, 1, from_there);
            means.irradiance = sum_of(means.irradiance, w.z, from_there);
            ++count;
        }
    for (double& value : means.radiance) value /= count;
    for (double& value : means.irradiance) value *= 2 * kPiDouble / count;
    return means;
}

/// Returns the map of a sky over a ground of even radiance, as colours over `unit`.
Image sky_image(const SkyModel& model, const Vec3d& to_sun, const SkyCurve& ground,
                const SkyCurve& unit) {
    const CurveColours colour_of;
    const Vec3d unit_colour = colour_of(unit);
    std::vector<float> texels(3 * kSide * kSide);
    parallel_for(kSide, [&](std::size_t y) {
        for (std::size_t x = 0; x < kSide; ++x) {
            const Vec3d w = texel_direction(x, y, kSide);
            const SkyCurve curve = w.z > 0 ? model.sky(w.z, w.dot(to_sun)) : ground;
            const Vec3d colour = colour_of(curve) / unit_colour;
            float* texel = &texels[3 * (y * kSide + x)];
            for (int c = 0; c < 3; ++c) texel[c] = static_cast<float>(std::max(0.0, colour[c]));
        }
    });
    constexpr auto kPixels = static_cast<int>(kSide);
    return {{kPixels, kPixels}, 3, std::move(texels)};
}

}  // namespace

Vec3d direction_to(const SunPosition& sun) {
    const SinCos azimuth = sin_cos_2pi(sun.azimuth / 360);
    const SinCos elevation = sin_cos_2pi(sun.elevation / 360);
    return {elevation.cos * azimuth.sin, elevation.cos * azimuth.cos, elevation.sin};
}

DaylightLights lights_of(const Daylight& daylight, const Affine& axes) {
    const double elevation = daylight.sun.elevation * kPiDouble / 180;
    const SkyModel model({.elevation = elevation,
                          .turbidity = daylight.turbidity,
                          .ground_albedo = daylight.ground_albedo});
    const Vec3d to_sun = direction_to(daylight.sun);
    const DomeMeans means = means_of(model, to_sun);
    const SkyCurve irradiance =
        sum_of(means.irradiance, to_sun.z, sun_irradiance(model, elevation));
    const SkyCurve ground = sum_of({}, daylight.ground_albedo / kPiDouble, irradiance);
    DaylightLights lights;
    lights.sky.curve = spectrum_of(means.radiance);
    lights.sky.image =
        image_of_directions(sky_image(model, to_sun, ground, means.radiance), DirectionMap());
    lights.sky.to_world = axes;
    lights.sun = sun_disc(model, elevation, -axes.vector(to_sun));
    return lights;
}

void add_daylight(SceneDescription& scene, const Daylight& daylight, const Affine& axes,
                  const SourceLocation& where) {
    DaylightLights lights = lights_of(daylight, axes);
    add_light(scene, {"sky", where}, std::move(lights.sky));
    if (lights.sun.curve.luminance() > 0) add_light(scene, {"sun", where}, std::move(lights.sun));
}

}  // namespace sunfleck::engine
