// Images of a point by the symmetries of each map, on the unit square.
#include "camera/film_images.h"

namespace sunfleck {
namespace {

/// Azimuth has a period of one; beyond a pole it is half a turn further.
std::vector<Vec2d> of_equirectangular(const Vec2d& u) {
    std::vector<Vec2d> all = {u, {u.x - 1, u.y}, {u.x + 1, u.y}};
    for (const double x : {u.x - 0.5, u.x + 0.5})
        for (const double y : {-u.y, 2 - u.y}) all.emplace_back(x, y);
    return all;
}

/// Each edge is folded onto itself around its middle.
std::vector<Vec2d> of_equal_area(const Vec2d& u) {
    std::vector<Vec2d> all = {u};
    for (const double edge : {0.0, 2.0}) {
        all.emplace_back(edge - u.x, 1 - u.y);
        all.emplace_back(1 - u.x, edge - u.y);
        for (const double other : {0.0, 2.0}) all.emplace_back(u.x + edge - 1, u.y + other - 1);
    }
    return all;
}

}  // namespace

std::vector<Vec2d> film_images(const Camera& camera, const Vec2d& film) {
    const auto* sphere = std::get_if<SphericalCamera>(&camera);
    if (sphere == nullptr) return {film};
    const Vec2d size(sphere->resolution);
    std::vector<Vec2d> all = sphere->map == SphereMap::equirectangular
                                 ? of_equirectangular(film / size)
                                 : of_equal_area(film / size);
    for (Vec2d& u : all) u *= size;
    return all;
}

}  // namespace sunfleck
