// Every light there is. To add one: docs/develop/adding.md.
#pragma once

#include "light/area_light.h"
#include "light/distant_light.h"
#include "light/image_infinite_light.h"
#include "light/infinite_light.h"
#include "light/picture_point_lights.h"
#include "light/point_light.h"
#include "light/portal_light.h"
#include "light/spot_light.h"

#include <variant>

namespace sunfleck::engine {

template <LightModel... Models>
using LightVariant = std::variant<Models...>;

using Light = LightVariant<PointLight, SpotLight, GoniometricLight, ProjectionLight, DistantLight,
                           InfiniteLight, ImageInfiniteLight, PortalLight, AreaLight>;

/// As `sunfleck info` says it.
inline std::string_view name_of(const Light& light) {
    return std::visit([](const auto& l) { return l.name; }, light);
}

inline Emission sample_emission(const Light& light, const std::array<double, 4>& u,
                                const SceneSphere& sphere) {
    return std::visit([&](const auto& l) { return l.sample_emission(u, sphere); }, light);
}

/// The u that leads to a ray (light/model.h).
inline EmissionDimensions emission_dimensions(const Light& light, const LightRay& ray,
                                              const SceneSphere& sphere) {
    return std::visit([&](const auto& l) { return l.emission_dimensions(ray, sphere); }, light);
}

/// Density of sample_emission() (light/model.h).
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

/// Do rays that leave the scene meet it?
inline bool is_infinite(const Light& light) {
    const auto has_beyond = [](const auto& l) {
        return requires(Vec3 w) {
            l.beyond(w, w);
        };
    };
    return std::visit(has_beyond, light);
}

/// Is its way to the scene without end?
inline bool comes_from_afar(const Light& light) {
    return std::visit([](const auto& l) { return l.comes_from_afar; }, light);
}

/// What comes to the point `from` from `direction` (unit, to the light), were nothing else there;
/// nothing from lights that are not infinite.
inline Beyond beyond(const Light& light, const Vec3& from, const Vec3& direction) {
    const auto ask = [&](const auto& l) {
        if constexpr (requires { l.beyond(from, direction); }) return l.beyond(from, direction);
        return Beyond{};
    };
    return std::visit(ask, light);
}

}  // namespace sunfleck::engine
