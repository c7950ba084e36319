// Emitters around a point of a floor, and the irradiance that each of them should bring there.
#pragma once

#include "support/direct_light.h"

#include <ostream>

namespace sunfleck::engine::testing_support {

constexpr float kRadiance = 2;

// Counter-clockwise as seen from below; standing, as seen from -x.
constexpr Corners kCeiling = {{{-1, -.5F, 2}, {-1, 1.5F, 2}, {1, 1.5F, 2}, {1, -.5F, 2}}};
constexpr Corners kCeilingUp = {{{-1, -.5F, 2}, {1, -.5F, 2}, {1, 1.5F, 2}, {-1, 1.5F, 2}}};
constexpr Corners kAttic = {{{-1, -1, 3}, {-1, 1, 3}, {1, 1, 3}, {1, -1, 3}}};
constexpr Corners kWall = {{{2, -1, .5F}, {2, -1, 2.5F}, {2, 1, 2.5F}, {2, 1, .5F}}};

inline Matrix moved(const Vec3d& to, const Vec3d& scale = Vec3d(1)) {
    Matrix matrix;
    matrix.translate(to);
    matrix.scale(scale);
    return matrix;
}

inline ShapeDescription quadric(const Shape& shape, const Matrix& to_world, bool flip) {
    return {{shape, to_world, flip}, 0, {}, {}};
}

inline InfiniteLight sky(float radiance) {
    return {Spectrum::constant(radiance)};
}

/// What kCeiling sends to the camera by way of the vertex: quadrature, 400^2 midpoints of the lamp.
inline double from_lamp(const CameraVertex& vertex, double radiance) {
    constexpr int kSide = 400;
    double sum = 0;
    for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i) {
            const Vec3d on(-1 + 2 * (i + 0.5) / kSide, -0.5 + 2 * (j + 0.5) / kSide, 2);
            const Vec3d to = on - kPoint;
            const Vec3 w = vertex.frame.to_local(Vec3(to.normalized()));
            const SampledSpectrum f = eval(vertex.bsdf, vertex.wo, w, Transport::radiance);
            const double cosine = to.z / to.length();
            sum += static_cast<double>(f[0]) * cosine * cosine / to.length2();
        }
    return sum * radiance * 4 / (kSide * kSide);
}

struct Case {
    const char* name;
    std::vector<ShapeDescription> shapes;
    std::vector<Light> lights;
    double irradiance;

    friend void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
};

inline double of_ellipsoid(const Vec3d& center, const Vec3d& axes) {
    return of_sight([&](const Vec3d& w) {
        const Vec3d o = (kPoint - center) / axes;
        const Vec3d d = w / axes;
        const double half = o.dot(d);
        return half * half - d.length2() * (o.length2() - 1) > 0 && half < 0 ? 1.0 : 0.0;
    });
}

inline std::vector<Case> area_cases() {
    const double ceiling = of_quad(kCeiling);
    const Vec3d ball(1, 1, 2);
    const Vec3d over(1, 0.5, 1.5);
    const Sphere whole{0.7, -0.7, 0.7};
    const auto disk = [&](bool flip) { return quadric(Disk{0, 1.2}, moved(over), flip); };
    return {
        {"quad", {lamp(quad(kCeiling), kRadiance)}, {}, kRadiance * ceiling},
        {"quad_upright", {lamp(quad(kWall), kRadiance)}, {}, kRadiance * of_quad(kWall)},
        {"quad_from_behind", {lamp(quad(kCeilingUp), kRadiance)}, {}, 0},
        {"quad_two_sided", {lamp(quad(kCeiling), kRadiance, true)}, {}, kRadiance * ceiling},
        {"quad_two_sided_from_behind",
         {lamp(quad(kCeilingUp), kRadiance, true)},
         {},
         kRadiance * ceiling},
        {"sphere",
         {lamp(quadric(whole, moved(ball), false), kRadiance)},
         {},
         kRadiance * of_sphere(ball, 0.7)},
        {"sphere_two_sided",
         {lamp(quadric(whole, moved(ball), true), kRadiance, true)},
         {},
         kRadiance * of_sphere(ball, 0.7)},
        {"sphere_shining_inwards", {lamp(quadric(whole, moved(ball), true), kRadiance)}, {}, 0},
        {"inside_of_a_sphere",
         {lamp(quadric(Sphere{3, -3, 3}, moved({1, 1, 0}), true), kRadiance)},
         {},
         kRadiance * kPiDouble},
        // A half of a dome around the point: half of the projected hemisphere.
        {"part_of_a_sphere",
         {lamp(quadric(Sphere{3, 0, 3, kPiDouble}, moved(kPoint), true), kRadiance)},
         {},
         kRadiance * kPiDouble / 2},
        {"ellipsoid",
         {lamp(quadric(Sphere{}, moved({1, 0, 1.5}, {0.4, 0.9, 0.6}), false), kRadiance)},
         {},
         kRadiance * of_ellipsoid({1, 0, 1.5}, {0.4, 0.9, 0.6})},
        {"disk", {lamp(disk(true), kRadiance)}, {}, kRadiance * of_disk(over, 1.2)},
        {"disk_from_behind", {lamp(disk(false), kRadiance)}, {}, 0},
        {"disk_two_sided",
         {lamp(disk(false), kRadiance, true)},
         {},
         kRadiance * of_disk(over, 1.2)},
    };
}

/// Several emitters; a lamp hides the sky behind it.
inline std::vector<Case> mixed_cases() {
    const double ceiling = of_quad(kCeiling);
    const double wall = of_quad(kWall);
    const PointLight bulb{Spectrum::constant(4), kPoint + Vec3d(0, 0, 1)};
    return {
        {"sky", {}, {sky(0.7F)}, 0.7 * kPiDouble},
        {"two_skies", {}, {sky(0.7F), sky(0.2F)}, 0.9 * kPiDouble},
        {"three_skies_and_a_quad",
         {lamp(quad(kCeiling), kRadiance)},
         {sky(0.1F), sky(0.2F), sky(0.4F)},
         0.7 * (kPiDouble - ceiling) + kRadiance * ceiling},
        {"sky_beside_a_dark_quad", {quad(kCeiling)}, {sky(1)}, kPiDouble - ceiling},
        {"two_quads_and_a_point",
         {lamp(quad(kCeiling), kRadiance), lamp(quad(kWall), 0.5F)},
         {bulb},
         kRadiance * ceiling + 0.5 * wall + 4},
        // Lamps that are no obstacle.
        {"sky_through_a_lamp",
         {lamp(quad(kCeiling, 2), kRadiance)},
         {sky(0.5F)},
         0.5 * kPiDouble + kRadiance * ceiling},
        {"lamps_and_a_point_through_a_lamp",
         {lamp(quad(kCeiling, 2), kRadiance), lamp(quad(kAttic, 2), 1)},
         {PointLight{Spectrum::constant(4), kPoint + Vec3d(0, 0, 4)}},
         kRadiance * ceiling + of_quad(kAttic) + 4.0 / 16},
    };
}

}  // namespace sunfleck::engine::testing_support
