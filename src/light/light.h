// Light: variant of all light models, with functions that dispatch to them. To add one:
// docs/develop/adding.md.
#pragma once

#include "light/area_light.h"
#include "light/distant_light.h"
#include "light/image_infinite_light.h"
#include "light/image_point_lights.h"
#include "light/infinite_light.h"
#include "light/medium_light.h"
#include "light/point_light.h"
#include "light/portal_light.h"
#include "light/spot_light.h"
#include "light/sun_light.h"

#include <variant>

namespace sunfleck::engine {

template <LightModel... Models>
using LightVariant = std::variant<Models...>;

using Light =
    LightVariant<PointLight, SpotLight, GoniometricLight, ProjectionLight, DistantLight, SunLight,
                 InfiniteLight, ImageInfiniteLight, PortalLight, AreaLight, MediumLight>;

/// As `sunfleck info` says it.
inline std::string_view name_of(const Light& light) {
    return std::visit([](const auto& l) { return l.name; }, light);
}

inline Emission sample_emission(const Light& light, const EmissionDimensions& u,
                                const SceneSphere& sphere) {
    return std::visit([&](const auto& l) { return l.sample_emission(u, sphere); }, light);
}

/// Returns the random numbers that sample_emission() maps to a ray (light/model.h).
inline EmissionDimensions emission_dimensions(const Light& light, const LightRay& ray,
                                              const SceneSphere& sphere) {
    return std::visit([&](const auto& l) { return l.emission_dimensions(ray, sphere); }, light);
}

/// Returns the density of sample_emission() at a ray (light/model.h).
inline double emission_pdf(const Light& light, const LightRay& ray, const SceneSphere& sphere) {
    return std::visit([&](const auto& l) { return l.emission_pdf(ray, sphere); }, light);
}

inline std::optional<DirectSample> sample_direct(const Light& light, const Vec3& point,
                                                 const Vec2& u, const SceneSphere& sphere) {
    return std::visit([&](const auto& l) { return l.sample_direct(point, u, sphere); }, light);
}

inline double power(const Light& light, const SceneSphere& sphere) {
    return std::visit([&](const auto& l) { return l.power(sphere); }, light);
}

inline const Spectrum& curve(const Light& light) {
    return std::visit([](const auto& l) -> const Spectrum& { return l.curve; }, light);
}

/// Returns whether rays that leave the scene receive radiance from the light.
inline bool is_infinite(const Light& light) {
    const auto has_environment = [](const auto& l) {
        return requires(Vec3 w) {
            l.environment_radiance(w, w);
        };
    };
    return std::visit(has_environment, light);
}

/// Returns whether the light is at infinity.
inline bool comes_from_afar(const Light& light) {
    return std::visit([](const auto& l) { return l.comes_from_afar; }, light);
}

/// Returns the unoccluded light at the point `from` from `direction` (unit, to the light); zero for
/// lights that are not infinite.
inline EnvironmentRadiance environment_radiance(const Light& light, const Vec3& from,
                                                const Vec3& direction) {
    const auto ask = [&](const auto& l) {
        if constexpr (requires { l.environment_radiance(from, direction); })
            return l.environment_radiance(from, direction);
        return EnvironmentRadiance{};
    };
    return std::visit(ask, light);
}

}  // namespace sunfleck::engine
