// Photons through a portal: they light nothing before it, what stands there stops them, and the
// floor gets what direct samples say.
#include "photon/tracer.h"

#include <gtest/gtest.h>

namespace sunfleck {
namespace {

/// A rectangle in x from x0 to x1, y from -3 to 3.
ShapeDescription plate(float z, float x0, float x1, std::uint32_t material = 0) {
    TriangleMesh mesh;
    mesh.positions = {{x0, -3, z}, {x1, -3, z}, {x1, 3, z}, {x0, 3, z}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return {{mesh, Matrix(), false}, material, {}, {}};
}

/// A portal in z = 1, open upwards; materials 0: white, 1: interface. A plate above it hides the
/// sky over x < 0, an interface all of it.
SceneDescription window() {
    SceneDescription scene;
    scene.materials = {DiffuseMaterial{SpectralCurve::constant(1)}, InterfaceMaterial{}};
    ShapeDescription veil = plate(1.2F, -3, 3, 1);
    veil.emission = AreaEmission{SpectralCurve::constant(1e-15F), false, 0};  // or it is left out
    scene.shapes = {plate(0, -3, 3), plate(1.5F, -3, 0), veil};
    PortalLight light;
    light.curve = SpectralCurve::constant(1);
    light.picture = std::make_shared<const PortalPicture>(16, [](const Vec3d&) { return Vec3(1); });
    light.frame.origin = {-0.5, -0.5, 1};
    light.extent = {1, 1};
    scene.lights = {light};
    return scene;
}

/// Sees 3% of the flux that arrives on the left and on the right half of the floor.
TEST(Portal, photons_bring_what_direct_samples_promise) {
    const Scene scene(window());
    const PassScene pass(scene, {1, 0});
    const TransportSettings transport{DirectLight::photons, 1};
    const PhotonTracer tracer(pass, transport);
    constexpr std::uint32_t kPaths = 400000;
    std::array<double, 2> photons{};
    std::array<double, 2> direct{};
    std::uint64_t rays = 0;
    for (std::uint32_t i = 0; i < kPaths; ++i) {
        const auto visit = [&](const Photon& photon) {
            EXPECT_LT(photon.position.z, 0.1F) << photon.position;
            photons.at(photon.position.x < 0 ? 0 : 1) +=
                static_cast<double>(photon.flux[0]) / kPaths;
            return true;
        };
        tracer.trace(IndependentReader(PassId{1, 0}.stream(Purpose::test, i)), visit, rays);
    }
    RandomStream random(4, Purpose::test, 1, 0);
    const std::size_t portal = scene.lights().size() - 1;
    for (std::uint32_t i = 0; i < kPaths; ++i) {
        const Vec3 on(6 * random.next_float() - 3, 6 * random.next_float() - 3, 0);
        const Vec2 u(random.next_float(), random.next_float());
        const auto s = sample_direct(scene.lights()[portal], on, u, scene.sphere());
        if (!s || !scene.is_free({on + Vec3(0, 0, 1e-4F), s->direction})) continue;
        direct.at(on.x < 0 ? 0 : 1) +=
            static_cast<double>(s->factor * s->direction.z) * 36 / kPaths;
    }
    for (const std::size_t side : {0U, 1U}) {
        EXPECT_GT(direct.at(side), 0.1);
        EXPECT_NEAR(photons.at(side), direct.at(side), 0.03 * direct.at(side)) << side;
    }
    EXPECT_GT(direct[0], 1.3 * direct[1]);  // from the right comes light to the left
}

}  // namespace
}  // namespace sunfleck
