// Looks for the way out.
#include "scene/outer_medium.h"

#include "scene/transmission.h"

#include <array>
#include <optional>
#include <vector>

namespace sunfleck {
namespace {

constexpr int kMostSurfaces = 1000;

std::optional<MediumNumber> far_along(const Scene& scene, Ray ray) {
    MediumNumber medium = scene.media().at_camera;
    for (int i = 0; i < kMostSurfaces; ++i) {
        const auto hit = scene.geometry().intersect(ray);
        if (!hit) return medium;
        if (!lets_light_through(scene.materials(), scene.material_of(*hit))) return {};
        medium = scene.medium_beyond(*hit, ray.direction, medium);
        ray = ray_from(*hit, ray.direction);
    }
    return {};
}

}  // namespace

MediumNumber outer_medium_of(const Scene& scene) {
    const Vec2d middle = Vec2d(scene.film().resolution) * 0.5;
    const CameraRay view = camera_ray(scene.camera(), middle, {0.5, 0.5});
    std::vector<Vec3> directions = {-Vec3(view.direction), Vec3(view.direction)};
    constexpr std::array<float, 3> kSteps = {-1, 0, 1};
    for (const float x : kSteps)
        for (const float y : kSteps)
            for (const float z : kSteps)
                if (Vec3(x, y, z) != Vec3(0)) directions.push_back(Vec3(x, y, z).normalized());
    for (const Vec3& direction : directions)
        if (const auto found = far_along(scene, {Vec3(view.origin), direction})) return *found;
    return 0;
}

}  // namespace sunfleck
