// Planarity by the distance from the mean plane, convexity by the orientation at each corner.
#include "import/ply/polygons.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr double kOfSize = 1e-4;
constexpr double kOfCoordinates = 1e-6;
constexpr double kOneAndAHalfTurns = 3 * kPiDouble;

/// Returns twice the area, along the mean normal (Newell).
Vec3d area_of(std::span<const Vec3d> corners) {
    Vec3d sum(0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
    return sum;
}

/// Returns the corners without consecutive repeats.
std::vector<Vec3d> without_repeats(std::span<const Vec3d> corners) {
    std::vector<Vec3d> result(corners.begin(), corners.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    while (result.size() > 1 && result.front() == result.back()) result.pop_back();
    return result;
}

}  // namespace

bool is_planar_and_convex(std::span<const Vec3d> corners) {
    const std::vector<Vec3d> distinct = without_repeats(corners);
    if (distinct.size() < 3) return true;
    double size = 0;
    double coordinate = 0;
    for (const Vec3d& corner : distinct) {
        size = std::max(size, (corner - distinct[0]).length());
        coordinate = std::max(coordinate, corner.length());
    }
    const double tolerance = kOfSize * size + kOfCoordinates * coordinate;
    const Vec3d area = area_of(distinct);
    const Vec3d normal = area.length() > tolerance * size ? area.normalized() : Vec3d(0);
    double turn = 0;
    for (std::size_t i = 0; i < distinct.size(); ++i) {
        const Vec3d& here = distinct[(i + 1) % distinct.size()];
        const Vec3d before = here - distinct[i];
        const Vec3d after = distinct[(i + 2) % distinct.size()] - here;
        const Vec3d cross = before.cross(after);
        const double slack = tolerance * (before.length() + after.length());
        if (normal == Vec3d(0) && cross.length() > slack) return false;
        if (std::abs((here - distinct[0]).dot(normal)) > tolerance) return false;
        if (cross.dot(normal) < -slack) return false;
        turn += std::atan2(cross.dot(normal), before.dot(after));
    }
    return normal == Vec3d(0) || turn < kOneAndAHalfTurns;
}

}  // namespace sunfleck::engine
