// Ear clipping (Meisters 1975) in the plane of the two coordinates that the normal has least of.
#include "import/obj/ear_clipping.h"

#include "import/obj/mesh.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Returns twice the area along the mean normal (Newell).
Vec3d mean_normal(std::span<const Vec3d> corners) {
    Vec3d sum(0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
    return sum;
}

/// Returns the corners seen along the normal, so that the outline turns left.
std::vector<Vec2d> flattened(std::span<const Vec3d> corners) {
    const Vec3d n = mean_normal(corners);
    int axis = 0;
    for (int c = 1; c < 3; ++c)
        if (std::abs(n[c]) > std::abs(n[axis])) axis = c;
    const int x = (axis + 1) % 3;
    const int y = (axis + 2) % 3;
    std::vector<Vec2d> flat;
    flat.reserve(corners.size());
    for (const Vec3d& p : corners)
        flat.push_back(n[axis] < 0 ? Vec2d(p[y], p[x]) : Vec2d(p[x], p[y]));
    return flat;
}

/// Returns twice the signed area of a triangle.
double turn(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    return (b - a).cross(c - a);
}

/// What is left of an outline: a ring of corners.
class Outline {
public:
    explicit Outline(std::vector<Vec2d> points) : points_(std::move(points)) {
        const auto count = static_cast<std::uint32_t>(points_.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            next_.push_back((i + 1) % count);
            previous_.push_back((i + count - 1) % count);
        }
        for (std::uint32_t i = 0; i < count; ++i)
            if (at(i) <= 0) concave_.push_back(i);
    }

    std::uint32_t next(std::uint32_t i) const { return next_[i]; }

    /// Returns whether the triangle of a corner and its neighbours is inside and empty.
    bool is_ear(std::uint32_t i) const {
        const Vec2d& a = points_[previous_[i]];
        const Vec2d& b = points_[i];
        const Vec2d& c = points_[next_[i]];
        if (!(turn(a, b, c) > 0)) return false;
        return std::none_of(concave_.begin(), concave_.end(), [&](std::uint32_t k) {
            const Vec2d& p = points_[k];
            if (p == a || p == b || p == c) return false;
            return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    }
    /// Returns whether neighbours and corner are on one line, so that nothing is lost without it.
    bool is_flat(std::uint32_t i) const { return at(i) == 0; }
    bool turns_right(std::uint32_t i) const { return at(i) < 0; }

    std::array<std::uint32_t, 3> cut(std::uint32_t i) {
        const std::uint32_t before = previous_[i];
        const std::uint32_t after = next_[i];
        next_[before] = after;
        previous_[after] = before;
        const auto is_convex_now = [&](std::uint32_t k) {
            return k == i || ((k == before || k == after) && at(k) > 0);
        };
        concave_.erase(std::remove_if(concave_.begin(), concave_.end(), is_convex_now),
                       concave_.end());
        return {before, i, after};
    }

private:
    double at(std::uint32_t i) const {
        return turn(points_[previous_[i]], points_[i], points_[next_[i]]);
    }

    std::vector<Vec2d> points_;
    std::vector<std::uint32_t> next_;
    std::vector<std::uint32_t> previous_;
    std::vector<std::uint32_t> concave_;  // corners that do not turn left
};

/// Orders the corners of a triangle as the polygon has them, lowest first.
std::array<std::uint32_t, 3> from_lowest(std::array<std::uint32_t, 3> t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

}  // namespace

bool is_convex_quad(const std::array<Vec3d, 4>& corners) {
    const Vec3d normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3d in = corners.at(i) - corners.at((i + 3) % 4);
        const Vec3d out = corners.at((i + 1) % 4) - corners.at(i);
        if (!(in.cross(out).dot(normal) > 0)) return false;
    }
    return true;
}

Triangulation triangulated(std::span<const Vec3d> corners) {
    Triangulation result;
    Outline outline(flattened(corners));
    std::uint32_t corner = 1;
    for (std::size_t left = corners.size(); left > 3; --left) {
        const std::uint32_t first = corner;
        std::uint32_t flat = kNoIndex;
        while (!outline.is_ear(corner)) {
            if (flat == kNoIndex && outline.is_flat(corner)) flat = corner;
            corner = outline.next(corner);
            if (corner != first) continue;
            result.is_simple = result.is_simple && flat != kNoIndex;
            if (flat != kNoIndex) corner = flat;
            break;
        }
        const std::uint32_t after = outline.next(corner);
        result.triangles.push_back(from_lowest(outline.cut(corner)));
        corner = after;
    }
    result.is_simple = result.is_simple && !outline.turns_right(corner);
    result.triangles.push_back(from_lowest(outline.cut(corner)));
    return result;
}

}  // namespace sunfleck::engine
