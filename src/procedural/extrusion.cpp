// Two filled copies of a shape and a wall around each of its edges.

#include "procedural/extrusion.h"

#include "math/trigonometry.h"
#include "procedural/flat_fill.h"

namespace sunfleck::engine {
namespace {

Polygon lifted(Polygon polygon, double height) {
    for (Vec3d& p : polygon) p.z = height;
    return polygon;
}

}  // namespace

Mesh extrude(const Polygon& edge, const std::vector<Polygon>& holes, double low, double high) {
    std::vector<Polygon> lifted_holes;
    lifted_holes.reserve(holes.size());
    for (const Polygon& hole : holes) lifted_holes.push_back(lifted(hole, high));
    Mesh body;
    fill(body, lifted(edge, high), lifted_holes);
    Mesh under = body;
    for (auto& p : under.points) p[2] = static_cast<float>(low);
    for (auto& t : under.triangles) std::swap(t[1], t[2]);
    body.append(under);
    const auto add_wall = [&](const Vec3d& a, const Vec3d& b) {
        add_polygon(body, {{a.x, a.y, low}, {b.x, b.y, low}, {b.x, b.y, high}, {a.x, a.y, high}});
    };
    for (std::size_t i = 0; i < edge.size(); ++i) add_wall(edge[i], edge[(i + 1) % edge.size()]);
    for (const Polygon& hole : holes)
        for (std::size_t i = 0; i < hole.size(); ++i)
            add_wall(hole[(i + 1) % hole.size()], hole[i]);
    return body;
}

Polygon rectangle(double left, double front, double right, double back) {
    return {{left, front, 0}, {right, front, 0}, {right, back, 0}, {left, back, 0}};
}

Polygon ellipse(double half_x, double half_y, std::size_t corners) {
    Polygon polygon;
    for (std::size_t i = 0; i < corners; ++i) {
        const SinCos t = sin_cos_2pi(static_cast<double>(i) / static_cast<double>(corners));
        polygon.emplace_back(half_x * t.cos, half_y * t.sin, 0);
    }
    return polygon;
}

Polygon arched(double left, double low, double right, double spring, std::size_t steps) {
    Polygon polygon = {{left, low, 0}, {right, low, 0}};
    const double radius = (right - left) / 2;
    for (std::size_t i = 0; i <= steps; ++i) {
        const SinCos t = sin_cos_2pi(0.5 * static_cast<double>(i) / static_cast<double>(steps));
        polygon.emplace_back(left + radius + radius * t.cos, spring + radius * t.sin, 0);
    }
    return polygon;
}

}  // namespace sunfleck::engine
