// Every light there is. To add one: write its header, then name it here and give an example in
// tests/laws/light_examples.h.
#pragma once

#include "light/area_light.h"
#include "light/distant_light.h"
#include "light/infinite_light.h"
#include "light/point_light.h"
#include "light/spot_light.h"

#include <variant>

namespace sunfleck {

template <LightModel... Models>
using LightVariant = std::variant<Models...>;

using Light = LightVariant<PointLight, SpotLight, DistantLight, InfiniteLight, AreaLight>;

inline Emission sample_emission(const Light& light, const std::array<double, 4>& u,
                                const SceneSphere& sphere) {
    return std::visit([&](const auto& l) { return l.sample_emission(u, sphere); }, light);
}

inline std::optional<DirectSample> sample_direct(const Light& light, const Vec3& point,
                                                 const Vec2& u, const SceneSphere& sphere) {
    return std::visit([&](const auto& l) { return l.sample_direct(point, u, sphere); }, light);
}

inline double power(const Light& light, const SceneSphere& sphere) {
    return std::visit([&](const auto& l) { return l.power(sphere); }, light);
}

inline const SpectralCurve& curve(const Light& light) {
    return std::visit([](const auto& l) -> const SpectralCurve& { return l.curve; }, light);
}

}  // namespace sunfleck
