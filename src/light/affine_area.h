// What an affine map does to areas, and whether spheres stay spheres under it.
#pragma once

#include "geometry/affine.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {

/// The image of a patch of unit area: its length is the new area, its direction the new normal,
/// on the same side of the surface (mirroring included). @param n  unit.
inline Vec3d area_vector(const Affine& map, const Vec3d& n) {
    const Vec3d v = map.y.cross(map.z) * n.x + map.z.cross(map.x) * n.y + map.x.cross(map.y) * n.z;
    return map.determinant() < 0 ? -v : v;
}

/// How many times larger the area becomes where the new normal is `n` (unit).
inline double area_ratio_of_image(const Affine& map, const Vec3d& n) {
    const Vec3d back(map.x.dot(n), map.y.dot(n), map.z.dot(n));  // along the old normal
    return std::abs(map.determinant()) / back.length();
}

/// Square of the scale, were the map a similarity.
inline double mean_scale2(const Affine& map) {
    return (map.x.length2() + map.y.length2() + map.z.length2()) / 3;
}

/// Are spheres still spheres (within a relative 1e-6, what rounded rotations need)?
inline bool is_similarity(const Affine& map) {
    const double scale2 = mean_scale2(map);
    const double skew = std::max(
        {std::abs(map.x.dot(map.y)), std::abs(map.y.dot(map.z)), std::abs(map.z.dot(map.x))});
    const double stretch =
        std::max({std::abs(map.x.length2() - scale2), std::abs(map.y.length2() - scale2),
                  std::abs(map.z.length2() - scale2)});
    return skew <= 1e-6 * scale2 && stretch <= 1e-6 * scale2;
}

}  // namespace sunfleck::engine
