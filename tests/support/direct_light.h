// Direct light at a point of a floor: scenes for it, its estimator's mean, and what it should be,
// by closed forms and quadrature that know nothing of how lights are sampled.
#pragma once

#include "camera_paths/next_event_estimation.h"
#include "core/random.h"

#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace sunfleck::engine::testing_support {

constexpr float kAlbedo = 0.5F;
inline const Vec3d kPoint(0.3, -0.2, 0);  // on the floor z = 0, normal +z

using Corners = std::array<Vec3, 4>;

/// Shines to the side from which its corners run counter-clockwise.
inline ShapeDescription quad(const Corners& corners, std::uint32_t material = 0) {
    TriangleMesh mesh;
    mesh.positions.assign(corners.begin(), corners.end());
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return {{mesh, Matrix(), false}, material, {}, {}};
}

inline ShapeDescription lamp(ShapeDescription shape, float radiance, bool two_sided = false) {
    shape.emission = AreaEmission{Spectrum::constant(radiance), two_sided, 0};
    return shape;
}

/// A large floor. Materials 0: diffuse, 1: rough metal, 2: interface, 3: thin glass.
inline SceneDescription floor_of(std::uint32_t material = 0) {
    SceneDescription scene;
    scene.materials = {
        DiffuseMaterial{Spectrum::constant(kAlbedo)},
        ConductorMaterial{Spectrum::constant(0.2F), Spectrum::constant(4), {}, {0.3F, 0.3F}},
        InterfaceMaterial{}, ThinDielectricMaterial{}};
    scene.shapes = {quad({{{-40, -40, 0}, {40, -40, 0}, {40, 40, 0}, {-40, 40, 0}}}, material)};
    return scene;
}

/// The floor at kPoint, seen along `direction`; the scene built and evaluated for one pass.
class LitPoint {
public:
    explicit LitPoint(SceneDescription description, const Vec3& direction = {-0.6F, 0, -0.8F})
        : scene_(std::move(description)),
          pass_(scene_, {5, 0}),
          hit_(scene_.geometry()
                   .intersect({Vec3(kPoint) - direction * 1e-4F, direction, 2e-4F})
                   .value()),
          vertex_{hit_, Frame(hit_.shading_normal, hit_.tangent), Vec3(0),
                  pass_.bsdf_at(hit_, room_)} {
        vertex_.wo = vertex_.frame.to_local(-direction);
    }
    LitPoint(const LitPoint&) = delete;
    LitPoint(LitPoint&&) = delete;
    LitPoint& operator=(const LitPoint&) = delete;
    LitPoint& operator=(LitPoint&&) = delete;
    ~LitPoint() = default;

    const Scene& scene() const { return scene_; }
    const PassScene& pass() const { return pass_; }
    const CameraVertex& vertex() const { return vertex_; }

    /// As CameraPathSettings has it.
    void leave_candidates_out() { vertex_.ris = false; }

    SampledSpectrum by_light(const LightNumbers& u, Statistics& statistics) const {
        return sample_lights(pass_, vertex_, u, statistics);
    }
    SampledSpectrum by_bsdf(const Vec3& u, Statistics& statistics) const {
        const auto drawn = sample(vertex_.bsdf, vertex_.wo, {u, Transport::radiance, {}});
        return drawn ? follow_bsdf_sample(pass_, vertex_, *drawn, statistics) : SampledSpectrum();
    }

private:
    Scene scene_;
    PassScene pass_;
    Hit hit_;
    std::optional<Bsdf> room_;
    CameraVertex vertex_;
};

/// Mean and half width of the 99% interval.
struct Interval {
    double mean = 0;
    double half = 0;
};

/// Reflected radiance, wavelength 0: 32 independent means of jittered samples; Student's t, 31
/// degrees.
inline Interval reflected(const LitPoint& point) {
    constexpr int kMeans = 32;
    constexpr int kSide = 48;
    constexpr double kStudent = 2.744;
    const auto cell = [](int x, int y, RandomStream& random) {
        return Vec2d((x + random.next()) / kSide, (y + random.next()) / kSide);
    };
    Statistics statistics;
    double sum = 0;
    double squares = 0;
    for (std::uint32_t i = 0; i < kMeans; ++i) {
        RandomStream random(1, Purpose::test, 0, i);
        double choice = random.next();  // a rotation by the golden ratio: even, in any stretch
        double mean = 0;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                choice += 0.6180339887498949;
                choice -= std::floor(choice);
                const Vec2d place = cell(x, y, random);
                mean += static_cast<double>(
                    point.by_light({choice, place, random.next()}, statistics)[0]);
                const Vec2d u = cell(x, y, random);
                mean += static_cast<double>(
                    point.by_bsdf({static_cast<float>(random.next()), static_cast<float>(u.x),
                                   static_cast<float>(u.y)},
                                  statistics)[0]);
            }
        mean /= kSide * kSide;
        sum += mean;
        squares += mean * mean;
    }
    const double mean = sum / kMeans;
    const double variance = std::max(0.0, squares / kMeans - mean * mean) / (kMeans - 1);
    return {mean, kStudent * std::sqrt(variance)};
}

/// Irradiance at kPoint of a polygon above the floor, per unit of radiance. Lambert 1760.
inline double of_polygon(const std::vector<Vec3d>& corners) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d a = (corners[i] - kPoint).normalized();
        const Vec3d b = (corners[(i + 1) % corners.size()] - kPoint).normalized();
        sum += std::acos(a.dot(b)) * a.cross(b).normalized().z;
    }
    return std::abs(sum) / 2;
}
inline double of_quad(const Corners& c) {
    return of_polygon({Vec3d(c[0]), Vec3d(c[1]), Vec3d(c[2]), Vec3d(c[3])});
}

/// Of a whole sphere above the floor.
inline double of_sphere(const Vec3d& center, double radius) {
    const Vec3d to = center - kPoint;
    return kPiDouble * radius * radius * to.z / (to.length2() * to.length());
}

/// Of a disk parallel to the floor (Howell, A Catalog of Radiation Heat Transfer Configuration
/// Factors, B-12 and B-13).
inline double of_disk(const Vec3d& center, double radius) {
    const Vec3d to = center - kPoint;
    const double r2 = radius * radius;
    const double d2 = to.length2();
    const double across2 = to.x * to.x + to.y * to.y;
    return kPiDouble / 2 * (1 - (d2 - r2) / std::sqrt((d2 + r2) * (d2 + r2) - 4 * across2 * r2));
}

/// Of whatever a ray from kPoint into a direction sees: its radiance over the projected
/// hemisphere (Nusselt 1928), by 2000^2 midpoints.
inline double of_sight(const std::function<double(const Vec3d&)>& radiance) {
    constexpr int kSide = 2000;
    double sum = 0;
    for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i) {
            const double x = (2 * i + 1.0) / kSide - 1;
            const double y = (2 * j + 1.0) / kSide - 1;
            if (x * x + y * y < 1) sum += radiance({x, y, std::sqrt(1 - x * x - y * y)});
        }
    return sum * 4 / (kSide * kSide);
}

}  // namespace sunfleck::engine::testing_support
