// Looks for the way out.
#include "scene/outer_medium.h"

#include <array>
#include <optional>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr int kMostSurfaces = 1000;

/// @param medium  in which the ray starts.
std::optional<MediumNumber> far_along(const Surfaces& surfaces, Ray ray, MediumNumber medium) {
    for (int i = 0; i < kMostSurfaces; ++i) {
        const auto hit = surfaces.geometry().intersect(ray);
        if (!hit) return medium;
        if (!surfaces.lets_light_through(*hit)) return {};
        medium = surfaces.medium_beyond(*hit, ray.direction, medium);
        ray = ray_from(*hit, ray.direction);
    }
    return {};
}

}  // namespace

MediumNumber outer_medium_of(const Surfaces& surfaces, const CameraView& view,
                             MediumNumber at_camera) {
    const CameraRay middle = view.middle_ray();
    std::vector<Vec3> directions = {-Vec3(middle.direction), Vec3(middle.direction)};
    constexpr std::array<float, 3> kSteps = {-1, 0, 1};
    for (const float x : kSteps)
        for (const float y : kSteps)
            for (const float z : kSteps)
                if (Vec3(x, y, z) != Vec3(0)) directions.push_back(Vec3(x, y, z).normalized());
    for (const Vec3& direction : directions)
        if (const auto found = far_along(surfaces, {Vec3(middle.origin), direction}, at_camera))
            return *found;
    return 0;
}

}  // namespace sunfleck::engine
