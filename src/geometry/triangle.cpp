// Exact place of a hit, and the error bound that keeps rays from meeting their own triangle.
#include "geometry/triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunfleck {
namespace {

/// The products a_j b_k that are rounded on the way to each component of a x b.
Vec3d rounded_products(const Vec3d& a, const Vec3d& b) {
    return {std::abs(a.z * b.y), std::abs(a.x * b.z), std::abs(a.y * b.x)};
}

/// Of the point of the border that is nearest to `place`.
Vec3d nearest_on_border(const Triangle& triangle, const Vec3d& place) {
    Vec3d weights(1, 0, 0);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3;
        const Vec3d& start = triangle.corner.at(static_cast<std::size_t>(i));
        const Vec3d edge = triangle.corner.at(static_cast<std::size_t>(next)) - start;
        const double along = std::clamp((place - start).dot(edge) / edge.dot(edge), 0.0, 1.0);
        const Vec3d apart = place - start - edge * along;
        if (!(apart.dot(apart) < least)) continue;
        least = apart.dot(apart);
        weights = Vec3d(0);
        weights[i] = 1 - along;
        weights[next] = along;
    }
    return weights;
}

}  // namespace

Vec3d barycentrics(const Triangle& triangle, const Vec3d& origin, const Vec3d& direction,
                   const Vec2d& fallback) {
    const Vec3d& p = triangle.corner[0];
    const Vec3d edge1 = triangle.corner[1] - p;
    const Vec3d edge2 = triangle.corner[2] - p;
    const Vec3d across = direction.cross(edge2);
    const double inverse = 1 / edge1.dot(across);
    const Vec3d to_origin = origin - p;
    double u = to_origin.dot(across) * inverse;
    double v = direction.dot(to_origin.cross(edge1)) * inverse;
    if (!std::isfinite(u + v)) {
        u = fallback.x;
        v = fallback.y;
    }
    const Vec3d weights(1 - u - v, u, v);
    constexpr double kOutside = -0x1p-10;
    if (u >= kOutside && v >= kOutside && weights.x >= kOutside) return weights;
    return nearest_on_border(triangle, triangle.point(weights));
}

/// Embree's robust test takes the sign of t from that of v0 . Ng, in float, where v_k is corner k
/// minus the ray's origin, the edges are e0 = v2 - v0, e1 = v0 - v1, e2 = v1 - v2, and each
/// component of Ng comes from e0 x e1 or e1 x e2, whichever rounds the smaller product. With r one
/// rounding and w the largest |v_k| of each axis, the error of v0 . Ng / |Ng| is at most the sum of
///  - r w . |n|: the rounding of v0 itself;
///  - 8 r w . |n|: an edge is off by de <= 4 r w, and the triple product (de, e, v0) is de . n
///    times |e x v0|, which is no more than |Ng|, for both lie in the triangle's plane;
///  - 4 r w . |n|: the rounding of Ng, and of the sum over the axes;
///  - r |v0| . m / |Ng|: the rounding of the smaller products m. It is large for caps (a corner
///    near the opposite edge), and there Embree is really that uncertain.
/// Rays that leave within about 2^-22 of the plane itself are not covered: there the sign of the
/// denominator is uncertain, too.
double plane_uncertainty(const Triangle& triangle, const Vec3d& area_vector,
                         const Vec3d& position) {
    const Vec3d v0 = triangle.corner[0] - position;
    const Vec3d v1 = triangle.corner[1] - position;
    const Vec3d v2 = triangle.corner[2] - position;
    Vec3d reach;
    for (int i = 0; i < 3; ++i)
        reach[i] = std::max({std::abs(v0[i]), std::abs(v1[i]), std::abs(v2[i])});
    const Vec3d e0 = v2 - v0;
    const Vec3d e1 = v0 - v1;
    const Vec3d e2 = v1 - v2;
    const Vec3d first = rounded_products(e0, e1);
    const Vec3d second = rounded_products(e1, e2);
    const Vec3d product(std::min(first.x, second.x), std::min(first.y, second.y),
                        std::min(first.z, second.z));
    const double twice_area = std::sqrt(area_vector.dot(area_vector));
    const double sum = 13 * absolute_dot(area_vector, reach) + 2 * absolute_dot(v0, product);
    return kFloatRounding * sum / twice_area;
}

double rounding_uncertainty(const Vec3d& normal, const Vec3d& position) {
    return 2.1 * kFloatRounding * absolute_dot(normal, position);
}

}  // namespace sunfleck
