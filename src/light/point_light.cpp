// Point light: even emission, inverse square.
#include "light/point_light.h"

#include "math/warp.h"

namespace sunfleck {

Emission PointLight::sample_emission(const std::array<double, 4>& u, const SceneSphere&) const {
    return {position, uniform_sphere({u[2], u[3]}), 4 * kPiDouble, Vec3(0), 0};
}

std::optional<DirectSample> PointLight::sample_direct(const Vec3& point, const Vec2&,
                                                      const SceneSphere&) const {
    const Vec3d to_light = position - Vec3d(point);
    const double distance2 = to_light.length2();
    if (!(distance2 > 0)) return {};
    const double distance = std::sqrt(distance2);
    return DirectSample{Vec3(to_light / distance), static_cast<float>(distance),
                        static_cast<float>(1 / distance2), std::nullopt};
}

}  // namespace sunfleck
