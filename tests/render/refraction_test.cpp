// Photons through a prism and through a drop of water, against the closed forms of optics: the
// angle of minimum deviation, the angle of the primary rainbow.
#include "photon/tracer.h"

#include <gtest/gtest.h>

#include <map>

namespace sunfleck::engine {
namespace {

constexpr double kDegree = kPiDouble / 180;

/// A flat piece with a strip's four corners; its normal by the right hand.
ShapeDescription plate(const std::array<Vec3, 4>& corners, std::uint32_t material) {
    TriangleMesh mesh;
    mesh.positions.assign(corners.begin(), corners.end());
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return {{mesh, Matrix(), false}, material, {}, {}};
}

/// A sun straight from above; materials 0: black, 1: clear, of that index.
SceneDescription sun_on(Spectrum eta) {
    SceneDescription scene;
    scene.materials = {DiffuseMaterial{Spectrum::constant(0)},
                       DielectricMaterial{std::move(eta), {}}};
    scene.lights = {DistantLight{Spectrum::constant(1), {0, 0, -1}}};
    return scene;
}

/// Calls visit(nm, photon) for photons of one wavelength that came by this many events.
/// @param visit  returns whether to go on.
template <class F>
void trace(const Scene& scene, PassId id, std::uint32_t paths, int events, const F& visit) {
    const PassScene pass(scene, id);
    const TransportSettings transport{DirectLight::photons, 5};
    const PhotonTracer tracer(pass, transport);
    std::uint64_t rays = 0;
    bool more = true;
    const auto see = [&](const Photon& photon) {
        if (photon.bounces != events) return;
        std::size_t wavelength = 0;
        while (wavelength < kWavelengths && photon.flux[wavelength] == 0) ++wavelength;
        more = visit(pass.wavelengths.nm.at(wavelength), photon);
    };
    for (std::uint32_t i = 0; i < paths && more; ++i)
        tracer.trace(IndependentReader(id.stream(Purpose::test, i)), see, rays);
}

/// Edge of a prism along y at the origin; between its faces, this angle.
constexpr double kApex = 60 * kDegree;
constexpr float kScreen = -0.5F;  // its height

/// Light falls on its first face at this angle, bends to +x and lands on a screen below.
Scene prism(double incidence) {
    SceneDescription scene = sun_on(*named_spectrum("glass-F11"));
    const auto at = [](double angle, float y) {
        return Vec3(static_cast<float>(std::cos(angle)), y, static_cast<float>(std::sin(angle)));
    };
    const double low = incidence - kApex;
    const Vec3 front(0, -1, 0);
    const Vec3 back(0, 1, 0);
    scene.shapes = {
        plate({front, at(incidence, -1), at(incidence, 1), back}, 1),
        plate({front, back, at(low, 1), at(low, -1)}, 1),
        plate({at(low, -1), at(low, 1), at(incidence, 1), at(incidence, -1)}, 0),  // its base
        plate(
            {Vec3(0, -1, kScreen), Vec3(6, -1, kScreen), Vec3(6, 1, kScreen), Vec3(0, 1, kScreen)},
            0)};
    return Scene(std::move(scene));
}

/// Turned by steps of a quarter degree, the prism deviates each wavelength least by
/// 2 asin(n sin(A / 2)) - A. The steps themselves add less than 0.001 degrees.
TEST(Refraction, prism_of_minimum_deviation) {
    std::map<float, double> least;  // by wavelength, in radians
    for (int quarters = 4 * 58; quarters <= 4 * 74; ++quarters) {
        const Scene scene = prism(0.25 * quarters * kDegree);
        for (std::uint32_t pass = 0; pass < 4; ++pass) {
            std::map<float, double> seen;
            trace(scene, {1, pass}, 3000, 2, [&](float nm, const Photon& photon) {
                if (photon.position.z == kScreen) seen[nm] = std::atan2(-photon.w.x, photon.w.z);
                return seen.size() < kWavelengths;
            });
            for (const auto& [nm, angle] : seen)
                least[nm] = least.contains(nm) ? std::min(least[nm], angle) : angle;
        }
    }
    EXPECT_EQ(least.size(), 4 * kWavelengths);
    const Spectrum eta = *named_spectrum("glass-F11");
    for (const auto& [nm, angle] : least) {
        const auto n = static_cast<double>(eta(nm));
        const double expected = 2 * std::asin(n * std::sin(kApex / 2)) - kApex;
        EXPECT_NEAR(angle / kDegree, expected / kDegree, 0.01) << nm;
    }
    EXPECT_GT(least.begin()->second - least.rbegin()->second, 5 * kDegree);  // violet, red
}

/// Refractive index of water at 20 degrees: the dispersion formula of Daimon and Masumura,
/// Applied Optics 46, 3811 (2007), table 1. @param nm  182 to 1129.
double water(double nm) {
    const double square = nm * nm * 1e-6;
    constexpr std::array<Vec2d, 4> kTerms = {
        Vec2d(5.684027565e-1, 5.101829712e-3), Vec2d(1.726177391e-1, 1.821153936e-2),
        Vec2d(2.086189578e-2, 2.620722293e-2), Vec2d(1.130748688e-1, 1.069792721e1)};
    double sum = 1;
    for (const Vec2d& term : kTerms) sum += term.x * square / (square - term.y);
    return std::sqrt(sum);
}

/// A drop of radius one, and above it a ring that sees what comes back.
Scene drop() {
    std::vector<TabulatedSpectrum::Point> points;
    for (int nm = 350; nm <= 840; nm += 10)
        points.push_back({static_cast<float>(nm), static_cast<float>(water(nm))});
    SceneDescription scene = sun_on(Spectrum::table(points));
    scene.shapes = {{{Sphere{}, Matrix(), false}, 1, {}, {}},
                    {{Disk{1.2, 3, 1.02}, Matrix(), false}, 0, {}, {}}};
    return Scene(std::move(scene));
}

/// Angle between what comes back after one reflection inside and the point opposite to the sun;
/// its greatest value, where light gathers. Source: Descartes; Born and Wolf, section 4.
double rainbow_angle(double n) {
    const double incidence = std::acos(std::sqrt((n * n - 1) / 3));
    return 4 * std::asin(std::sin(incidence) / n) - 2 * incidence;
}

/// No photon is farther out than the rainbow of its wavelength, and there they gather as at every
/// fold of light: from the edge inwards their number grows by the square root of the angle. Violet
/// is at 40.6 degrees, red at 42.4. Sees an index off by 0.0005.
TEST(Refraction, primary_rainbow) {
    constexpr double kBin = 0.2 * kDegree;
    const Scene scene = drop();
    std::array<int, 5> bins{};                // by the distance from the edge, inwards
    std::array edges = {Vec2d(0), Vec2d(0)};  // of violet and of red: seen, by the closed form
    for (std::uint32_t pass = 0; pass < 64; ++pass)
        trace(scene, {2, pass}, 30000, 3, [&](float nm, const Photon& photon) {
            const double angle = std::atan2(std::hypot(photon.w.x, photon.w.y), -photon.w.z);
            const double edge = rainbow_angle(water(static_cast<double>(nm)));
            EXPECT_LT(angle, edge + 0.005 * kDegree) << nm;  // the table is linear in between
            const double inwards = std::max(0.0, edge - angle) / kBin;
            if (inwards < bins.size()) ++bins.at(static_cast<std::size_t>(inwards));
            if (nm < 420 && angle > edges[0].x) edges[0] = {angle, edge};
            if (nm > 670 && nm < 710 && angle > edges[1].x) edges[1] = {angle, edge};
            return true;
        });
    double sum = 0;
    for (std::size_t i = 0; i < bins.size(); ++i) {
        sum += bins.at(i);
        const double expected = bins[0] * std::sqrt(static_cast<double>(i + 1));
        EXPECT_NEAR(sum, expected, 0.15 * expected) << i;
    }
    EXPECT_GT(bins[0], 300);
    for (const Vec2d& edge : edges) EXPECT_NEAR(edge.x / kDegree, edge.y / kDegree, 0.05);
    EXPECT_NEAR(edges[0].x / kDegree, 40.65, 0.2);
    EXPECT_NEAR(edges[1].x / kDegree, 42.4, 0.15);
}

}  // namespace
}  // namespace sunfleck::engine
