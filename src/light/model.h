// What a light must offer, as a concept, and what it hands on.
//
// Two users: photon paths start with sample_emission(); camera paths ask sample_direct() and, when
// a ray meets an emitter or leaves the scene, radiance() and direct_pdf() for the other half of
// MIS. Curves are evaluated once a pass: a light's functions return a unitless or geometric factor
// and `LightSpectra` holds each light's emission at the pass's wavelengths. A light with a picture
// adds a tint: linear sRGB of luminance one, whose smooth spectrum multiplies the curve.
#pragma once

#include "geometry/ray.h"
#include "math/spectrum.h"
#include "math/vector.h"

#include <array>
#include <concepts>
#include <optional>
#include <string_view>

namespace sunfleck::engine {

/// The sphere around everything: where distant and infinite lights shoot from.
struct SceneSphere {
    Vec3d center{0};
    double radius = 1;
};

/// The start of a photon path, in double: a disc of 10 km must aim at 1 mm.
struct Emission {
    Vec3d origin;
    Vec3d direction;  // unit, away from the light
    /// Flux per unit of the light's curve: factor * curve = Le |cos| / (pdf position * pdf
    /// direction). The choice of the light is not in it.
    double factor = 0;
    Vec3 normal;                 // geometric, of an area light's surface; zero for others
    float error = 0;             // bound of the origin's error on an area light
    std::optional<Vec3> tint{};  // of lights with pictures: multiplies the curve
    /// What the photon meets nearer than this stops it unlit: it is not yet through the portal.
    double unlit = 0;
};

/// A place of a light, and a way that light goes from there. Of lights that come from afar the
/// origin is any point of that way; the way through a portal does go through it.
struct LightRay {
    Vec3d origin;
    Vec3 normal{0};   // as Emission::normal
    Vec3d direction;  // unit, away from the light
};

/// Numbers of (0,1): position (2), direction (2).
using EmissionDimensions = std::array<double, 4>;

/// One sample of the light that arrives straight at a point.
struct DirectSample {
    Vec3 direction;  // unit, from the point to the light
    float distance = kInfinity;
    float factor = 0;  // radiance (or irradiance, for delta lights) per unit of the curve, / pdf
    std::optional<float> pdf;  // per steradian at the point; none for delta lights
    std::optional<Vec3> tint{};
    Vec3 normal{0};  // as Emission::normal: of the place on an area light
};

/// What an infinite light sends to a point from one direction.
struct Beyond {
    float factor = 0;  // radiance per unit of the curve
    float pdf = 0;     // per steradian, of sample_direct(): the other half of MIS
    std::optional<Vec3> tint{};
};

/// name:       as `sunfleck info` says it.
/// emission:   u in (0,1)^4: position (2), direction (2). Continuous and gentle in u.
/// emission_dimensions: the u that sample_emission() takes to a ray: its inverse, within 1e-6; for
/// a ray
///             that it cannot give, anything.
/// emission_pdf: density of sample_emission() at a ray that it may give, per m^2 and sr (m^2 across
///             the ray for lights from afar); per sr alone for points, per m^2 for distant lights.
///             Exact, but for pictures on surfaces: there as if their table had no cells.
/// direct:     a direction to the light from `point`, u in (0,1)^2; nothing if it cannot be seen
///             (behind a one-sided emitter, outside a spot).
/// power:      total emitted flux per unit of the curve (in sr m^2, or m^2 for distant lights).
/// curve:      the emission's spectrum.
/// comes_from_afar: whether its way to the scene is without end.
/// beyond:     of infinite lights alone: what a point gets from a direction.
template <class L>
concept LightModel = std::copyable<L> &&
    requires(const L& light, const Vec3& p, const Vec2& u2, const std::array<double, 4>& u4,
             const LightRay& ray, const SceneSphere& sphere) {
    { L::name } -> std::convertible_to<std::string_view>;
    { light.sample_emission(u4, sphere) } -> std::same_as<Emission>;
    { light.emission_dimensions(ray, sphere) } -> std::same_as<EmissionDimensions>;
    { light.emission_pdf(ray, sphere) } -> std::same_as<double>;
    { light.sample_direct(p, u2, sphere) } -> std::same_as<std::optional<DirectSample>>;
    { light.power(sphere) } -> std::same_as<double>;
    { light.curve } -> std::convertible_to<Spectrum>;
    { L::comes_from_afar } -> std::convertible_to<bool>;
};

}  // namespace sunfleck::engine
