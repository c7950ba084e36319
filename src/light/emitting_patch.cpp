// Points of emitting bilinear patches.
#include "light/emitting_surface.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {
namespace {

/// Density in (u, v) up to a factor: the area at the corners, bilinear between them. Where the
/// patch is flat this is the area everywhere.
struct Density {
    std::array<double, 4> at_corner{};  // 00, 10, 01, 11

    explicit Density(const Bilinear& surface) {
        const std::array<Vec3d, 4> areas = surface.area_vectors_at_corners();
        for (std::size_t i = 0; i < 4; ++i) at_corner.at(i) = areas.at(i).length();
    }
    double side(std::size_t first, double v) const {
        return at_corner.at(first) * (1 - v) + at_corner.at(first + 2) * v;
    }
    double operator()(const Vec2d& uv) const {
        return side(0, uv.y) * (1 - uv.x) + side(1, uv.y) * uv.x;
    }
    double mean() const { return (*this)({0.5, 0.5}); }
};

/// x in (0, 1) with a density that is linear from a to b, by inversion.
double sample_linear(double u, double a, double b) {
    const double sum = a + std::sqrt(a * a * (1 - u) + b * b * u);
    return sum > 0 ? std::min(u * (a + b) / sum, 1.0) : u;
}

/// The u that sample_linear() takes to x.
double linear_number(double x, double a, double b) {
    return a + b > 0 ? x * (2 * a + (b - a) * x) / (a + b) : x;
}

double spread_at(const Bilinear& surface, const Density& density, const Vec2d& uv) {
    const double here = density(uv);
    return here > 0 ? surface.area_vector(uv).length() * density.mean() / here : 0;
}

}  // namespace

SurfaceSample sample_surface(const EmittingPatch& patch, const Vec2d& u) {
    const Density density(patch.surface);
    const auto& a = density.at_corner;
    const double v = sample_linear(u.y, a[0] + a[1], a[2] + a[3]);
    const Vec2d uv(sample_linear(u.x, density.side(0, v), density.side(1, v)), v);
    Vec3d normal = patch.surface.area_vector(uv) * (patch.flip ? -1 : 1);
    const Vec3d given = bilinear(patch.normals, uv);
    if (normal.dot(given) < 0) normal = -normal;
    const double length = normal.length();
    normal = length > 0 ? normal / length : Vec3d(0, 0, 1);
    return {patch.surface.point(uv), normal, spread_at(patch.surface, density, uv)};
}

Vec2d surface_square(const EmittingPatch& patch, const Vec3d& on, const Vec3d& normal) {
    const Density density(patch.surface);
    const auto& a = density.at_corner;
    const Vec2d uv = patch.surface.locate(on, normal);
    return {linear_number(uv.x, density.side(0, uv.y), density.side(1, uv.y)),
            linear_number(uv.y, a[0] + a[1], a[2] + a[3])};
}

double surface_spread(const EmittingPatch& patch, const Vec3d& on, const Vec3d& normal) {
    return spread_at(patch.surface, Density(patch.surface), patch.surface.locate(on, normal));
}

double surface_area(const EmittingPatch& patch) {
    return patch.surface.area();
}

}  // namespace sunfleck::engine
