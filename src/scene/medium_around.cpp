// Walks along one way.
#include "scene/medium_around.h"

namespace sunfleck::engine {
namespace {

Vec3 the_way() {
    return {0.36F, 0.48F, 0.8F};
}

/// Calls visit(hit) for surfaces in order until it returns false.
template <class Visit>
void for_each_surface(const Surfaces& surfaces, const Vec3& point, const Visit& visit) {
    constexpr int kMost = 1000;
    Ray ray{point, the_way()};
    for (int i = 0; i < kMost; ++i) {
        const auto hit = surfaces.geometry().intersect(ray);
        if (!hit || !visit(*hit)) return;
        ray = ray_from(*hit, the_way());
    }
}

}  // namespace

MediumNumber medium_around(const Surfaces& surfaces, const Vec3& point, MediumNumber last) {
    MediumNumber around = last;
    for_each_surface(surfaces, point, [&](const Hit& hit) {
        around = surfaces.medium_beyond(hit, -the_way(), last);
        return !surfaces.separates_media(hit);
    });
    return around;
}

MediumNumber medium_behind_all(const Surfaces& surfaces, const Vec3& point, MediumNumber medium) {
    for_each_surface(surfaces, point, [&](const Hit& hit) {
        medium = surfaces.medium_beyond(hit, the_way(), medium);
        return true;
    });
    return medium;
}

}  // namespace sunfleck::engine
