// LightModel: the concept that lights satisfy, with the types of what they return.
//
// Photon paths start with sample_emission(). Camera paths call sample_direct() and, where a ray
// hits an emitter or leaves the scene, radiance() and direct_pdf() for the other strategy of MIS.
// Curves are evaluated once a pass: a light's functions return a unitless or geometric factor and
// `LightSpectra` holds each light's emission at the pass's wavelengths. A light with an image adds
// an RGB factor: linear sRGB of luminance one, whose smooth spectrum multiplies the curve.
#pragma once

#include "geometry/ray.h"
#include "math/spectrum.h"
#include "math/vector.h"

#include <array>
#include <concepts>
#include <limits>
#include <optional>
#include <string_view>

namespace sunfleck::engine {

/// Bounding sphere of the scene, from which distant and infinite lights emit.
struct SceneSphere {
    Vec3d center{0};
    double radius = 1;
};

/// First ray of a photon path. It is in double precision: a disc of 10 km must aim at 1 mm.
struct Emission {
    Vec3d origin;
    Vec3d direction;  // unit, away from the light
    /// Flux per unit of the light's curve: factor * curve = Le |cos| / (pdf position * pdf
    /// direction). The probability of choosing the light is not in it.
    double factor = 0;
    Vec3 normal;                // geometric, of an area light's surface; zero for others
    float error = 0;            // bound of the origin's error on an area light
    std::optional<Vec3> rgb{};  // of lights with images: multiplies the curve
    /// Distance to the light's portal: a photon that hits a surface before it carries no flux.
    double unlit = 0;
    /// Distance at which the light ends: a photon from within a sphere that rays do not hit carries
    /// no flux outside of it, since direct samples from there know its near side alone.
    double lit_to = std::numeric_limits<double>::infinity();
};

/// Ray along which a light emits. For lights at infinity the origin is any point of the ray; rays
/// through a portal do intersect it.
struct LightRay {
    Vec3d origin;
    Vec3 normal{0};   // as Emission::normal
    Vec3d direction;  // unit, away from the light
};

/// Random numbers in (0,1) of an emission: position (2), direction (2), depth within a medium,
/// which other lights do not read.
using EmissionDimensions = std::array<double, 5>;
/// In their place what the light does not read: any number leads to the same emission.
inline constexpr double kUnread = std::numeric_limits<double>::quiet_NaN();

/// Sample of the direct light at a point.
struct DirectSample {
    Vec3 direction;  // unit, from the point to the light
    float distance = kInfinity;
    float factor = 0;  // radiance (or irradiance, for delta lights) per unit of the curve, / pdf
    std::optional<float> pdf;  // per steradian at the point; none for delta lights
    std::optional<Vec3> rgb{};
    Vec3 normal{0};  // as Emission::normal: of the sampled point on an area light
};

/// Unoccluded radiance of an infinite light at a point, from one direction.
struct EnvironmentRadiance {
    float factor = 0;  // radiance per unit of the curve
    float pdf = 0;     // per steradian, of sample_direct(): for MIS
    std::optional<Vec3> rgb{};
};

/// name:       name that `sunfleck info` prints.
/// emission:   u in (0,1)^5. Continuous in u.
/// emission_dimensions: inverse of sample_emission(), within 1e-6; unspecified for a ray that
///             sample_emission() cannot return.
/// emission_pdf: density of sample_emission() at a ray, per m^2 and sr (m^2 across the ray for
///             lights at infinity, m^3 in a medium); per sr for point lights, per m^2 for distant
///             lights. Exact,
///             except for images on surfaces: there it ignores the cells of their table.
/// direct:     samples a direction from `point` to the light, u in (0,1)^2; nothing if the light is
///             invisible (behind a one-sided emitter, outside a spot).
/// power:      emitted flux per unit of the curve (in sr m^2, m^2 for distant lights, or sr m^3).
/// curve:      the emission's spectrum.
/// comes_from_afar: whether the light is at infinity.
/// environment_radiance: of infinite lights: radiance at a point from a direction.
template <class L>
concept LightModel = std::copyable<L> &&
    requires(const L& light, const Vec3& p, const Vec2& u2, const EmissionDimensions& u5,
             const LightRay& ray, const SceneSphere& sphere) {
    { L::name } -> std::convertible_to<std::string_view>;
    { light.sample_emission(u5, sphere) } -> std::same_as<Emission>;
    { light.emission_dimensions(ray, sphere) } -> std::same_as<EmissionDimensions>;
    { light.emission_pdf(ray, sphere) } -> std::same_as<double>;
    { light.sample_direct(p, u2, sphere) } -> std::same_as<std::optional<DirectSample>>;
    { light.power(sphere) } -> std::same_as<double>;
    { light.curve } -> std::convertible_to<Spectrum>;
    { L::comes_from_afar } -> std::convertible_to<bool>;
};

}  // namespace sunfleck::engine
