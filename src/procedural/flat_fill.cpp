// Holes are joined to the edge by bridges, then ears are cut off one by one.
//
// Source: Eberly, Triangulation by Ear Clipping (2002); bridges here are the shortest free ones.

#include "procedural/flat_fill.h"

#include <algorithm>
#include <limits>

namespace sunfleck::engine {
namespace {

/// Twice the area of a triangle seen from above; positive when counter-clockwise.
double area2(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Do the open segments a-b and c-d cross?
bool cross(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
    return area2(a, b, c) * area2(a, b, d) < 0 && area2(c, d, a) * area2(c, d, b) < 0;
}

bool crosses(const Vec3d& a, const Vec3d& b, const Polygon& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
        if (cross(a, b, polygon[i], polygon[(i + 1) % polygon.size()])) return true;
    return false;
}

/// Does the way from corner i to `to` begin inside the polygon? (A corner where a bridge begins is
/// there twice, with another part of the inside each time.)
bool begins_inside(const Polygon& polygon, std::size_t i, const Vec3d& to) {
    const Vec3d& before = polygon[(i + polygon.size() - 1) % polygon.size()];
    const Vec3d& after = polygon[(i + 1) % polygon.size()];
    const bool left_of_way_in = area2(before, polygon[i], to) > 0;
    const bool left_of_way_out = area2(polygon[i], after, to) > 0;
    const bool convex = area2(before, polygon[i], after) > 0;
    return convex ? left_of_way_in && left_of_way_out : left_of_way_in || left_of_way_out;
}

/// The corners of the hole, walked backwards, put into the edge by a bridge to and fro.
void join(Polygon& edge, const Polygon& hole, const std::vector<Polygon>& holes) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t from = 0;
    std::size_t to = 0;
    for (std::size_t i = 0; i < edge.size(); ++i)
        for (std::size_t j = 0; j < hole.size(); ++j) {
            const double length = (edge[i] - hole[j]).length();
            if (length >= least || !begins_inside(edge, i, hole[j])) continue;
            const auto in_the_way = [&](const Polygon& p) { return crosses(edge[i], hole[j], p); };
            if (in_the_way(edge) || std::any_of(holes.begin(), holes.end(), in_the_way)) continue;
            least = length;
            from = i;
            to = j;
        }
    Polygon joined(edge.begin(), edge.begin() + static_cast<std::ptrdiff_t>(from) + 1);
    for (std::size_t k = 0; k <= hole.size(); ++k)
        joined.push_back(hole[(to + hole.size() - k) % hole.size()]);
    joined.insert(joined.end(), edge.begin() + static_cast<std::ptrdiff_t>(from), edge.end());
    edge = std::move(joined);
}

/// Is the triangle of corner i and its neighbours free of all other corners?
bool is_ear(const Polygon& polygon, std::size_t i) {
    const Vec3d& a = polygon[(i + polygon.size() - 1) % polygon.size()];
    const Vec3d& b = polygon[i];
    const Vec3d& c = polygon[(i + 1) % polygon.size()];
    if (!(area2(a, b, c) > 0)) return false;
    return std::none_of(polygon.begin(), polygon.end(), [&](const Vec3d& p) {
        return p != a && p != b && p != c && area2(a, b, p) >= 0 && area2(b, c, p) >= 0 &&
               area2(c, a, p) >= 0;
    });
}

}  // namespace

void fill(Mesh& mesh, const Polygon& edge, const std::vector<Polygon>& holes) {
    Polygon left = edge;
    for (const Polygon& hole : holes) join(left, hole, holes);
    while (left.size() >= 3) {
        std::size_t ear = 0;
        while (ear < left.size() && !is_ear(left, ear)) ++ear;
        if (ear == left.size()) return;
        const std::size_t before = (ear + left.size() - 1) % left.size();
        add_polygon(mesh, {left[before], left[ear], left[(ear + 1) % left.size()]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
}

}  // namespace sunfleck::engine
