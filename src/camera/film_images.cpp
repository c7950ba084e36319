// Images of a point by the symmetries of each map, on the unit square.
#include "camera/film_images.h"

namespace sunfleck::engine {
namespace {

/// Azimuth has a period of one; beyond a pole it is half a turn further.
template <class Add>
void add_equirectangular(const Vec2d& u, const Add& add) {
    for (const double x : {u.x, u.x - 1, u.x + 1}) add(x, u.y);
    for (const double x : {u.x - 0.5, u.x + 0.5})
        for (const double y : {-u.y, 2 - u.y}) add(x, y);
}

/// Each edge is folded onto itself around its middle.
template <class Add>
void add_equal_area(const Vec2d& u, const Add& add) {
    add(u.x, u.y);
    for (const double edge : {0.0, 2.0}) {
        add(edge - u.x, 1 - u.y);
        add(1 - u.x, edge - u.y);
        for (const double other : {0.0, 2.0}) add(u.x + edge - 1, u.y + other - 1);
    }
}

}  // namespace

FilmPoints film_images(const Camera& camera, const Vec2d& film) {
    FilmPoints images;
    const auto* sphere = std::get_if<SphericalCamera>(&camera);
    if (sphere == nullptr) {
        images.add(film);
        return images;
    }
    const Vec2d size(sphere->resolution);
    const auto add = [&](double x, double y) { images.add(Vec2d(x, y) * size); };
    if (sphere->map == SphereMap::equirectangular)
        add_equirectangular(film / size, add);
    else
        add_equal_area(film / size, add);
    return images;
}

}  // namespace sunfleck::engine
