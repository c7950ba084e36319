// The way from a lit point to a light that is a point.
#pragma once

#include "math/vector.h"

#include <optional>

namespace sunfleck::engine {

struct TowardsPoint {
    Vec3d direction;  // unit
    double distance2 = 0;
    double distance = 0;
};

/// Nothing where the two are one.
inline std::optional<TowardsPoint> towards_point(const Vec3d& light, const Vec3& point) {
    const Vec3d way = light - Vec3d(point);
    const double distance2 = way.length2();
    if (!(distance2 > 0)) return {};
    const double distance = std::sqrt(distance2);
    return TowardsPoint{way / distance, distance2, distance};
}

}  // namespace sunfleck::engine
