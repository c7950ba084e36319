// Rays, matrices and meshes for the tests of geometry.
#pragma once

#include "core/random.h"
#include "geometry/geometry.h"

#include <cmath>

namespace sunfleck::engine::test {

/// Random things of one test; the number names the stream.
class Dice {
public:
    explicit Dice(std::uint32_t number) : stream_(20240607, Purpose::test, 0, number) {}

    double number(double from, double to) { return from + (to - from) * stream_.next(); }
    std::uint32_t below(std::uint32_t count) {
        return static_cast<std::uint32_t>(stream_.next_fraction() % count);
    }
    Vec3d in_box(double half) {
        const double x = number(-half, half);
        const double y = number(-half, half);
        return {x, y, number(-half, half)};
    }
    Vec3d direction() {
        for (;;) {
            const Vec3d v = in_box(1);
            const double length2 = v.dot(v);
            if (length2 < 1 && length2 > 1e-4) return v / std::sqrt(length2);
        }
    }
    /// Unit vector as close as floats come.
    Vec3 direction_float() { return {direction()}; }
    /// 10^number(low, high).
    double magnitude(double low, double high) { return std::pow(10, number(low, high)); }

private:
    RandomStream stream_;
};

inline Matrix scaling(double x, double y, double z) {
    return {x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1};
}
inline Matrix translation(const Vec3d& t) {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, t.x, t.y, t.z, 1};
}
/// About an axis, counter-clockwise. @param angle  radians.
inline Matrix rotation(const Vec3d& axis, double angle) {
    Matrix m;
    m.setAxisAngle(axis, angle);
    return m;
}

inline TriangleMesh one_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    TriangleMesh mesh;
    mesh.positions = {a, b, c};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

/// A bumpy ball of about 2 * steps * steps triangles; from outside they run counter-clockwise.
inline TriangleMesh bumpy_ball(std::uint32_t steps, double bumps, bool with_normals) {
    TriangleMesh mesh;
    Dice dice(1);
    for (std::uint32_t i = 0; i <= steps; ++i)
        for (std::uint32_t j = 0; j <= steps; ++j) {
            const double theta = kPiDouble * i / steps;
            const double phi = 2 * kPiDouble * j / steps;
            const Vec3d n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                          std::cos(theta));
            const double bump = i == 0 || i == steps ? 0 : bumps * dice.number(-1, 1);
            const Vec3 seam = j == steps ? mesh.positions[mesh.positions.size() - steps] : Vec3(0);
            mesh.positions.emplace_back(j == steps ? seam : Vec3(n * (1 + bump)));
            if (with_normals) mesh.normals.emplace_back(n);
            mesh.uvs.emplace_back(static_cast<float>(j) / static_cast<float>(steps),
                                  static_cast<float>(i) / static_cast<float>(steps));
        }
    for (std::uint32_t i = 0; i < steps; ++i)
        for (std::uint32_t j = 0; j < steps; ++j) {
            const std::uint32_t a = i * (steps + 1) + j;
            const std::uint32_t below = a + steps + 1;
            mesh.triangles.push_back({a, below, a + 1});
            mesh.triangles.push_back({a + 1, below, below + 1});
        }
    return mesh;
}

/// A geometry of one shape that stands in the world.
inline Geometry of_one(const Shape& shape, const Matrix& to_world = Matrix(), bool flip = false) {
    GeometryInput input;
    input.shapes.push_back({shape, to_world, flip});
    input.in_world = {0};
    return Geometry(std::move(input));
}

inline Ray ray_between(const Vec3d& from, const Vec3d& to) {
    const Vec3d way = to - from;
    return {Vec3(from), Vec3(way / std::sqrt(way.dot(way))), kInfinity};
}

/// The ray that leaves a hit.
inline Ray leaving(const Hit& hit, const Vec3& direction) {
    return {offset_origin(hit.position, hit.normal, hit.error, direction), direction, kInfinity};
}

inline double distance(const Vec3d& a, const Vec3d& b) {
    return (a - b).length();
}

}  // namespace sunfleck::engine::test
