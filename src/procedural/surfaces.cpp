// Grids of ring and ball form, and the surfaces made of them.

#include "procedural/surfaces.h"

#include "math/trigonometry.h"
#include "procedural/placement.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

double share(std::size_t i, std::size_t of) {
    return static_cast<double>(i) / static_cast<double>(of);
}

/// |x|^power with the sign of x.
double signed_power(double x, float power) {
    const auto size = std::pow(static_cast<float>(std::abs(x)), power);
    return x < 0 ? -size : size;
}

}  // namespace

Mesh ring_grid(std::size_t along, std::size_t around, const SurfacePoint& point) {
    Mesh mesh;
    const auto at = [&](std::size_t i, std::size_t j) {
        return static_cast<std::uint32_t>(i % along * around + j % around);
    };
    for (std::size_t i = 0; i < along; ++i)
        for (std::size_t j = 0; j < around; ++j) {
            mesh.points.push_back(rounded_point(point(share(i, along), share(j, around))));
            mesh.add_quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
    return mesh;
}

Mesh ball_grid(std::size_t around, std::size_t rings, const SurfacePoint& point) {
    Mesh mesh;
    mesh.points.push_back(rounded_point(point(0, 0)));
    for (std::size_t i = 1; i < rings; ++i)
        for (std::size_t j = 0; j < around; ++j)
            mesh.points.push_back(rounded_point(point(share(j, around), share(i, rings))));
    mesh.points.push_back(rounded_point(point(0, 1)));
    const auto at = [&](std::size_t ring, std::size_t j) {
        return static_cast<std::uint32_t>(1 + (ring - 1) * around + j % around);
    };
    const auto top = static_cast<std::uint32_t>(mesh.points.size() - 1);
    for (std::size_t j = 0; j < around; ++j) {
        mesh.triangles.push_back({0, at(1, j + 1), at(1, j)});
        for (std::size_t i = 1; i + 1 < rings; ++i)
            mesh.add_quad(at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
        mesh.triangles.push_back({at(rings - 1, j), at(rings - 1, j + 1), top});
    }
    return mesh;
}

Vec3d sphere_point(double turn, double height) {
    const SinCos t = sin_cos_2pi(turn);
    const SinCos h = sin_cos_2pi(height / 2 - 0.25);
    return {h.cos * t.cos, h.cos * t.sin, h.sin};
}

Mesh superellipsoid(const Vec3d& half, float power, std::size_t around, std::size_t rings) {
    return ball_grid(around, rings, [&](double turn, double height) {
        const SinCos t = sin_cos_2pi(turn);
        const SinCos h = sin_cos_2pi(height / 2 - 0.25);
        const double waist = signed_power(h.cos, power);
        return Vec3d(half.x * waist * signed_power(t.cos, power),
                     half.y * waist * signed_power(t.sin, power),
                     half.z * signed_power(h.sin, power));
    });
}

Mesh closed_tube(const std::vector<Vec3d>& chain, double radius, std::size_t around) {
    const std::size_t size = chain.size();
    // Each ring lies across the way between the neighbours; its first point is that of the ring
    // before, carried along. What is left to close the turn is spread over all rings.
    std::vector<Vec3d> ways(size);
    for (std::size_t i = 0; i < size; ++i)
        ways[i] = (chain[(i + 1) % size] - chain[(i + size - 1) % size]).normalized();
    std::vector<Vec3d> sides(size);
    Vec3d side = std::abs(ways[0].z) < 0.9 ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0);
    for (std::size_t i = 0; i < size; ++i) {
        side = (side - ways[i] * ways[i].dot(side)).normalized();
        sides[i] = side;
    }
    side = (side - ways[0] * ways[0].dot(side)).normalized();
    const auto off_x = static_cast<float>(side.dot(sides[0]));
    const auto off_y = static_cast<float>(side.dot(sides[0].cross(ways[0])));
    const double off = static_cast<double>(std::atan2(off_y, off_x)) / (2 * kPiDouble);
    return ring_grid(size, around, [&](double along, double turn) {
        const auto i = static_cast<std::size_t>(std::lround(along * static_cast<double>(size)));
        const SinCos t = sin_cos_2pi(turn - off * along);
        return chain[i] + (sides[i] * t.cos + sides[i].cross(ways[i]) * t.sin) * radius;
    });
}

Mesh torus(double radius, double thickness, std::size_t along, std::size_t around) {
    return ring_grid(along, around, [&](double turn, double across) {
        const SinCos t = sin_cos_2pi(turn);
        const SinCos a = sin_cos_2pi(across);
        const double r = radius + thickness * a.cos;
        return Vec3d(r * t.cos, r * t.sin, thickness * a.sin);
    });
}

}  // namespace sunfleck::engine
