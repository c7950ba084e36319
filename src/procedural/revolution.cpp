// Profiles turned around the z axis.

#include "procedural/revolution.h"

#include "math/trigonometry.h"

namespace sunfleck::engine {
namespace {

ProfilePoint bezier_point(const std::array<ProfilePoint, 4>& p, double t) {
    const double s = 1 - t;
    const std::array<double, 4> w = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    return {w[0] * p[0].radius + w[1] * p[1].radius + w[2] * p[2].radius + w[3] * p[3].radius,
            w[0] * p[0].height + w[1] * p[1].height + w[2] * p[2].height + w[3] * p[3].height};
}

/// The points of one ring, or the one point of a pole.
std::size_t append_ring(Mesh& mesh, const ProfilePoint& ring, std::size_t segments) {
    const std::size_t count = ring.radius == 0 ? 1 : segments;
    for (std::size_t i = 0; i < count; ++i) {
        const SinCos turn = sin_cos_2pi(static_cast<double>(i) / static_cast<double>(segments));
        mesh.points.push_back({static_cast<float>(ring.radius * turn.cos),
                               static_cast<float>(ring.radius * turn.sin),
                               static_cast<float>(ring.height)});
    }
    return count;
}

}  // namespace

void append_bezier(Profile& profile, const std::array<ProfilePoint, 3>& control, int steps) {
    const std::array<ProfilePoint, 4> points = {profile.back(), control[0], control[1], control[2]};
    for (int i = 1; i < steps; ++i)
        profile.push_back(bezier_point(points, static_cast<double>(i) / steps));
    profile.push_back(control[2]);
}

Mesh revolve(const Profile& profile, std::size_t segments) {
    Mesh mesh;
    std::size_t size = append_ring(mesh, profile.front(), segments);
    for (std::size_t p = 1; p < profile.size(); ++p) {
        const std::size_t first = mesh.points.size() - size;
        const std::size_t next = mesh.points.size();
        const std::size_t next_size = append_ring(mesh, profile[p], segments);
        const auto below = [&](std::size_t i) {
            return static_cast<std::uint32_t>(first + i % segments);
        };
        const auto above = [&](std::size_t i) {
            return static_cast<std::uint32_t>(next + i % segments);
        };
        for (std::size_t i = 0; i < segments; ++i) {
            if (size == 1)
                mesh.triangles.push_back({below(0), above(i + 1), above(i)});
            else if (next_size == 1)
                mesh.triangles.push_back({below(i), below(i + 1), above(0)});
            else
                mesh.add_quad(below(i), below(i + 1), above(i + 1), above(i));
        }
        size = next_size;
    }
    return mesh;
}

Mesh fill_ring(const ProfilePoint& ring, std::size_t segments) {
    Mesh mesh;
    append_ring(mesh, ring, segments);
    std::size_t low = 0;
    std::size_t high = segments - 1;
    // Triangles to and fro between the two halves of the ring.
    for (bool from_low = true; high - low > 1; from_low = !from_low) {
        const std::size_t apex = from_low ? low + 1 : high - 1;
        mesh.triangles.push_back({static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(apex),
                                  static_cast<std::uint32_t>(high)});
        (from_low ? low : high) = apex;
    }
    return mesh;
}

}  // namespace sunfleck::engine
