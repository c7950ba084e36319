// A leaf is a polygon with a random position and rotation in the canopy.

#include "procedural/leaves.h"

#include "math/trigonometry.h"
#include "procedural/placement.h"
#include "procedural/scene_random.h"

#include <cmath>

namespace sunfleck::engine {
namespace {

constexpr int kCorners = 20;

/// Returns a direction, uniform over the sphere.
Vec3d random_direction(SceneRandom& random) {
    for (;;) {
        const double x = random.between(-1, 1);
        const double y = random.between(-1, 1);
        const double z = random.between(-1, 1);
        const double square = x * x + y * y + z * z;
        if (square > 0.1 && square < 1) return Vec3d(x, y, z) / std::sqrt(square);
    }
}

/// Returns a leaf at the origin: along x, broader towards its stalk, both ends pointed.
Mesh leaf(double length) {
    Mesh mesh;
    for (int i = 0; i < kCorners; ++i) {
        const SinCos t = sin_cos_2pi(static_cast<double>(i) / kCorners);
        const double half_width = 0.25 * length * t.sin * t.sin * (1 - t.cos / 2);
        mesh.points.push_back(
            rounded_point({length / 2 * t.cos, t.sin < 0 ? -half_width : half_width, 0}));
    }
    for (std::uint32_t i = 1; i + 1 < kCorners; ++i) mesh.triangles.push_back({0, i, i + 1});
    return mesh;
}

}  // namespace

Mesh canopy(const Canopy& canopy) {
    const double flat = std::sqrt(canopy.sun.x * canopy.sun.x + canopy.sun.y * canopy.sun.y);
    const Vec3d across(canopy.sun.y / flat, -canopy.sun.x / flat, 0);
    const Vec3d up = across.cross(canopy.sun);
    SceneRandom random(3);
    Mesh all;
    for (int placed_leaves = 0; placed_leaves < canopy.leaves;) {
        const double a = canopy.half_width * random.between(-1, 1);
        const double b = canopy.half_height * random.between(-1, 1);
        const double distance = random.between(canopy.nearest, canopy.farthest);
        const double length = random.between(3.5, 6);
        const double x = a / (canopy.gap_width + 0.4 * length);
        const double y = b / (canopy.gap_height + 0.4 * length);
        if (x * x + y * y < 1) continue;
        const Vec3d along = random_direction(random);
        const Vec3d face = along.cross(random_direction(random)).normalized();
        all.append(placed(leaf(length),
                          {.x = along,
                           .y = face.cross(along),
                           .z = face,
                           .origin = canopy.place + across * a + up * b + canopy.sun * distance}));
        ++placed_leaves;
    }
    return all;
}

}  // namespace sunfleck::engine
