// One photon path at a time: kinds, sides, bounces and ends; what stands before a portal.
#include "traced_paths.h"

#include <gtest/gtest.h>

#include <set>
#include <span>
#include <vector>

namespace sunfleck::engine {
namespace {

TEST(PhotonTracer, first_photon_is_direct_and_comes_from_the_light) {
    int met = 0;
    for (const Path& path : paths_of(sunny({square(0, 0)}), 64)) {
        if (path.photons.empty()) {
            EXPECT_EQ(path.end, PathEnd::escaped);
            continue;
        }
        ++met;
        EXPECT_EQ(path.photons.size(), 1U);
        EXPECT_EQ(path.photons[0].kind, PhotonKind::direct);
        EXPECT_EQ(path.photons[0].bounces, 0);
        EXPECT_EQ(path.photons[0].w, Vec3(0, 0, 1));
        EXPECT_EQ(path.photons[0].normal, Vec3(0, 0, 1));
        EXPECT_TRUE(path.end == PathEnd::absorbed || path.end == PathEnd::escaped);
    }
    EXPECT_GT(met, 500);
}

/// Glass keeps no photon and makes the next one a caustic; a grey floor makes it indirect.
TEST(PhotonTracer, kinds_follow_what_scattered_the_photon) {
    int caustic = 0;
    int indirect = 0;
    for (const Path& path : paths_of(sunny({square(0, 0), square(1, 1)}), 64)) {
        for (const Photon& photon : path.photons) {
            EXPECT_EQ(photon.position.z, 0);
            EXPECT_NE(photon.kind, PhotonKind::direct);
            const bool first = &photon == path.photons.data();
            EXPECT_EQ(photon.kind == PhotonKind::caustic, first);
            EXPECT_EQ(photon.bounces == 1, first);
            ++(first ? caustic : indirect);
        }
    }
    EXPECT_GT(caustic, 500);
    EXPECT_GT(indirect, 5);
}

/// Camera paths bring what a diffuse surface sends on of light straight from a lamp; what glass
/// sends on stays with photons, beyond the floor, too.
TEST(PhotonTracer, leaves_light_of_a_diffuse_first_surface_to_camera_paths) {
    TransportSettings transport{DirectLight::sampled, 64};
    transport.indirect = IndirectLight::sampled;
    for (const Path& path : paths_of(sunny({square(0, 0)}), transport)) {
        EXPECT_TRUE(path.photons.empty());
        EXPECT_LE(path.rays, 1U);
    }
    int beyond_the_floor = 0;
    for (const Path& path : paths_of(sunny({square(0, 0), square(1, 1)}), transport)) {
        if (path.photons.empty()) continue;
        EXPECT_EQ(path.photons.front().kind, PhotonKind::caustic);
        beyond_the_floor += path.photons.size() > 1 ? 1 : 0;
    }
    EXPECT_GT(beyond_the_floor, 5);
}

/// Of a varnished first surface photons bring the reflection by the coat alone.
TEST(PhotonTracer, leaves_the_base_of_a_coated_first_surface_to_camera_paths) {
    TransportSettings transport{DirectLight::sampled, 64};
    transport.indirect = IndirectLight::sampled;
    int reflected = 0;
    SceneDescription scene = sunny({square(0, 4), square(1, 0)});
    scene.materials.emplace_back(CoatedDiffuseMaterial{
        Spectrum::constant(0.5F), std::make_shared<const Coat>(1.5F, std::nullopt, 0.0F)});
    scene.lights = {DistantLight{Spectrum::constant(1), Vec3d(0.8, 0, -0.6)}};
    for (const Path& path : paths_of(scene, transport)) {
        if (path.photons.empty()) continue;
        ++reflected;
        EXPECT_EQ(path.photons.front().kind, PhotonKind::caustic);
        EXPECT_EQ(path.photons.front().position.z, 1);
    }
    EXPECT_GT(reflected, 3);
}

/// Between panes some light goes to and fro: few events or many, by smooth surfaces alone.
TEST(PhotonTracer, many_smooth_surfaces_make_a_deep_caustic) {
    for (const int panes :
         {int{kLongSpecularChain} - 1, int{kLongSpecularChain}, int{kLongSpecularChain} + 3}) {
        std::vector<ShapeDescription> sheets = {square(0, 0)};
        for (int i = 1; i <= panes; ++i) sheets.push_back(square(0.1F * static_cast<float>(i), 1));
        int deep = 0;
        int shallow = 0;
        for (const Path& path : paths_of(sunny(sheets), 64)) {
            if (path.photons.empty()) continue;
            const Photon& first = path.photons.front();
            const bool is_long_chain = first.bounces >= kLongSpecularChain;
            EXPECT_EQ(first.kind,
                      is_long_chain ? PhotonKind::long_specular_chain : PhotonKind::caustic);
            ++(is_long_chain ? deep : shallow);
            for (const Photon& later : std::span(path.photons).subspan(1))
                EXPECT_EQ(later.kind, PhotonKind::indirect);
        }
        EXPECT_GT(deep, 20);
        EXPECT_EQ(shallow > 20, panes < kLongSpecularChain);
    }
}

TEST(PhotonTracer, photons_from_below_have_their_normal_below) {
    SceneDescription scene = sunny({square(0, 0)});
    scene.lights = {DistantLight{Spectrum::constant(1), {0, 0, 1}}};
    int met = 0;
    for (const Path& path : paths_of(scene, 64))
        for (const Photon& photon : path.photons) {
            ++met;
            EXPECT_EQ(photon.normal, Vec3(0, 0, -1));
        }
    EXPECT_GT(met, 500);
}

/// Between white sheets: paths end by leaving or by depth, never by absorption.
TEST(PhotonTracer, depth_counts_events) {
    SceneDescription scene = sunny({square(0, 2), square(0.1F, 2)});
    scene.lights = {PointLight{Spectrum::constant(1), {0, 0, 0.05}}};
    for (const int depth : {1, 3, 10}) {
        int cut = 0;
        for (const Path& path : paths_of(scene, depth)) {
            EXPECT_LE(path.photons.size(), static_cast<std::size_t>(depth));
            EXPECT_NE(path.end, PathEnd::absorbed);
            if (path.end != PathEnd::too_long) continue;
            ++cut;
            EXPECT_EQ(path.photons.size(), static_cast<std::size_t>(depth));
            EXPECT_EQ(path.rays, static_cast<std::uint64_t>(depth));
        }
        EXPECT_GT(cut, 100);
    }
}

TEST(PhotonTracer, glossy_surfaces_keep_photons_and_make_them_indirect) {
    int second = 0;
    for (const Path& path : paths_of(sunny({square(0, 3), square(1, 1)}), 64))
        for (std::size_t i = 0; i < path.photons.size(); ++i) {
            EXPECT_EQ(path.photons[i].kind == PhotonKind::indirect, i > 0);
            second += i > 0 ? 1 : 0;
        }
    EXPECT_GT(second, 5);
}

/// Bounce dimensions of the first event, read by any of 200 paths onto a surface of that material.
std::set<BounceDimension> read_at(std::uint32_t material) {
    const Scene scene(sunny({square(0, material)}));
    const PassScene pass(scene, {1, 0});
    const TransportSettings transport{DirectLight::photons, 2};
    const PhotonTracer tracer(pass, transport);
    std::set<BounceDimension> dimensions;
    std::uint64_t rays = 0;
    for (std::uint32_t i = 0; i < 200; ++i) {
        IndependentReader numbers(PassId{1, 0}.stream(Purpose::test, i));
        const auto read = [&](std::uint32_t index) {
            const std::uint32_t first = dimension(0, BounceDimension{});
            if (index >= first) dimensions.insert(static_cast<BounceDimension>(index - first));
            return numbers(index);
        };
        tracer.trace(
            read, [](const Photon&) { return true; }, rays);
    }
    return dimensions;
}

TEST(PhotonTracer, a_surface_reads_the_numbers_that_it_needs) {
    using enum BounceDimension;
    EXPECT_EQ(read_at(0), (std::set{direction_u, direction_v, roulette}));
    EXPECT_EQ(read_at(2), (std::set{direction_u, direction_v}));  // white: nothing is absorbed
    EXPECT_EQ(read_at(3), (std::set{lobe, direction_u, direction_v, roulette}));
    const std::set<BounceDimension> glass = read_at(1);
    EXPECT_TRUE(glass.contains(lobe));
    EXPECT_FALSE(glass.contains(direction_u) || glass.contains(direction_v));
}

TEST(PhotonTracer, nothing_starts_without_a_light) {
    SceneDescription scene = sunny({square(0, 0)});
    scene.lights.clear();
    EXPECT_EQ(paths_of(scene, 64, 1)[0].end, PathEnd::no_light);
}

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
    scene.materials = {DiffuseMaterial{Spectrum::constant(1)}, InterfaceMaterial{}};
    ShapeDescription veil = plate(1.2F, -3, 3, 1);
    veil.emission = AreaEmission{Spectrum::constant(1e-15F), false, 0};  // or it is left out
    scene.shapes = {plate(0, -3, 3), plate(1.5F, -3, 0), veil};
    PortalLight light;
    light.curve = Spectrum::constant(1);
    light.image = std::make_shared<const PortalImage>(16, [](const Vec3d&) { return Vec3(1); });
    light.frame.origin = {-0.5, -0.5, 1};
    light.extent = {1, 1};
    scene.lights = {light};
    return scene;
}

/// Sees 3% of the flux that arrives on the left and on the right half of the floor.
TEST(PhotonTracer, portals_bring_what_direct_samples_promise) {
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
}  // namespace sunfleck::engine
