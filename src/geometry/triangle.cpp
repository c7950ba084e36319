// The border of a triangle, and the error bound that keeps rays from meeting their own triangle.
#include "geometry/triangle.h"

#include <limits>

namespace sunfleck::engine {

Vec3d weights_on_border(const Triangle& triangle, const Vec3d& weights) {
    const Vec3d place = triangle.point(weights);
    Vec3d nearest(1, 0, 0);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3;
        const Vec3d& start = triangle.corner.at(static_cast<std::size_t>(i));
        const Vec3d edge = triangle.corner.at(static_cast<std::size_t>(next)) - start;
        const double along = std::clamp((place - start).dot(edge) / edge.dot(edge), 0.0, 1.0);
        const Vec3d apart = place - start - edge * along;
        if (!(apart.dot(apart) < least)) continue;
        least = apart.dot(apart);
        nearest = Vec3d(0);
        nearest[i] = 1 - along;
        nearest[next] = along;
    }
    return nearest;
}

double plane_uncertainty(const Triangle& triangle, const Vec3d& area_vector,
                         const Vec3d& position) {
    const double twice_area = std::sqrt(area_vector.dot(area_vector));
    const double sum =
        scaled_plane_uncertainty(triangle, TriangleEdges(triangle), area_vector, position);
    return kFloatRounding * sum / twice_area;
}

}  // namespace sunfleck::engine
