// Where camera paths end, and with which discs.
#include "camera_paths/camera_path.h"

#include "camera_paths/trace_camera_paths.h"
#include "support/visible_points.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

constexpr int kPixels = 16;

/// A square of side 4 at height z, facing up.
ShapeDescription square(float z, std::uint32_t material) {
    TriangleMesh mesh;
    mesh.positions = {{-2, -2, z}, {2, -2, z}, {2, 2, z}, {-2, 2, z}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return {{mesh, Matrix(), false}, material, {}, {}};
}

/// The camera at height 4 looks down, 20 degrees wide. Materials 0: grey 0.5, 1: thin glass,
/// 2: rough metal.
SceneDescription seen_from_above(std::vector<ShapeDescription> shapes) {
    SceneDescription scene;
    scene.materials = {
        DiffuseMaterial{}, ThinDielectricMaterial{},
        ConductorMaterial{Spectrum::constant(0.2F), Spectrum::constant(4), {}, {0.3F, 0.3F}}};
    scene.shapes = std::move(shapes);
    Matrix camera(1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 4, 1);
    scene.film.resolution = Vec2i(kPixels, kPixels);
    scene.camera = make_perspective(camera, scene.film.resolution, 20, 1, {});
    scene.filter = {FilterKind::box, {0.5, 0.5}};
    return scene;
}

struct Seen {
    std::vector<VisiblePoint> points;
    Statistics statistics;
    double emission = 0;  // sum over pixels, red
};

Seen trace(const SceneDescription& description, const TransportSettings& transport,
           double radius_factor = 1, const CameraPathSettings& settings = {},
           std::uint32_t number = 0) {
    const Scene scene(description);
    const PassId id{2, number};
    const PassScene pass(scene, id);
    PassImage image(kPixels * kPixels, AovSet{});
    Seen seen;
    seen.points = testing_support::joined(
        trace_camera_paths({pass, transport, settings, {0, 0, kPixels, kPixels}, id, radius_factor},
                           image, seen.statistics));
    for (std::size_t i = 0; i < image.pixels(); ++i)
        seen.emission += image.value(Aov::total, i, 0).to_double();
    return seen;
}

/// Log2Samples 0 to 4, pixel by pixel.
std::vector<std::uint8_t> mixed_log2_samples() {
    std::vector<std::uint8_t> log2_samples(kPixels * kPixels);
    for (std::size_t i = 0; i < log2_samples.size(); ++i)
        log2_samples[i] = static_cast<std::uint8_t>(i % 5);
    return log2_samples;
}

const TransportSettings kSampled{DirectLight::sampled, 64};
const TransportSettings kPhotons{DirectLight::photons, 64};

TEST(CameraPath, a_diffuse_surface_ends_every_path) {
    const Seen seen = trace(seen_from_above({square(0, 0)}), kSampled);
    ASSERT_EQ(seen.points.size(), static_cast<std::size_t>(kPixels * kPixels));
    EXPECT_EQ(seen.statistics[Count::visible_points], seen.points.size());
    for (std::size_t i = 0; i < seen.points.size(); ++i) {
        const VisiblePoint& p = seen.points[i];
        EXPECT_EQ(p.pixel, i);
        EXPECT_EQ(p.bsdf, kLambertian);
        EXPECT_NEAR(p.throughput[0], 0.5 / kPiDouble, 1e-6);
        EXPECT_EQ(p.disc.normal, Vec3(0, 0, 1));
        EXPECT_EQ(p.disc.bounces, 0);
        EXPECT_FALSE(p.disc.both_sides);
        EXPECT_EQ(p.disc.kinds, 2 + 4 + 8);  // no direct light, which is sampled
    }
    for (const VisiblePoint& p : trace(seen_from_above({square(0, 0)}), kPhotons).points)
        EXPECT_EQ(p.disc.kinds, 15);
}

/// A pixel footprint, the pixel's width on the floor, for the picture is small; and the schedule's
/// factor, and fixed.
TEST(CameraPath, first_radius) {
    const double pixel = 2 * 4 * std::tan(10 * kPiDouble / 180) / kPixels;
    const auto radius = [&](double factor, const CameraPathSettings& settings) {
        return static_cast<double>(
            trace(seen_from_above({square(0, 0)}), kSampled, factor, settings)
                .points[kPixels * kPixels / 2 + kPixels / 2]
                .disc.radius);
    };
    EXPECT_NEAR(radius(1, {}), pixel, 0.01 * pixel);
    EXPECT_NEAR(radius(0.5, {}), pixel / 2, 0.005 * pixel);
    EXPECT_NEAR(radius(1, {6, {}}), 6 * pixel, 0.06 * pixel);
    EXPECT_NEAR(radius(0.5, {2, 0.25}), 0.125, 1e-6);
}

/// Of a crop, too, it is that of the whole picture.
TEST(CameraPath, first_radius_goes_by_the_size_of_the_film) {
    SceneDescription scene = seen_from_above({square(0, 0)});
    const auto first = [&] {
        const Scene whole(scene);
        const PassId id{2, 0};
        const PassScene pass(whole, id);
        const CameraPathSettings settings;
        return CameraPass{pass, kSampled, settings, {3, 3, 5, 5}, id}.first_radius;
    };
    EXPECT_EQ(first(), 1);
    scene.film.resolution = Vec2i(512, 512);
    EXPECT_EQ(first(), 2);
}

/// Of thin glass that is met head-on, by far; index 1.5: what both faces throw back together.
constexpr double kPane = 2 * 0.04 / 1.04;

TEST(CameraPath, smooth_glass_is_crossed_and_counted) {
    const Seen seen = trace(seen_from_above({square(0, 0), square(1, 1)}), kSampled);
    // What glass reflects goes to the sky, and is followed, too.
    ASSERT_EQ(seen.points.size(), static_cast<std::size_t>(kPixels * kPixels));
    EXPECT_EQ(seen.statistics[Count::camera_rays], 3U * kPixels * kPixels);
    for (const VisiblePoint& p : seen.points) {
        EXPECT_EQ(p.disc.position.z, 0);
        EXPECT_EQ(p.disc.bounces, 1);
        EXPECT_FALSE(p.after_rough);
        EXPECT_NEAR(p.throughput[0], 0.5 / kPiDouble * (1 - kPane), 2e-4);
    }
}

/// Light that goes to and fro between two panes (faint, and by chance alone) arrives in the mean:
/// half a percent of all, and .06% is the standard error. It comes in no flashes: a path that is
/// kept by chance counts no more than the root of its branch.
TEST(CameraPath, both_ways_at_glass_are_followed_until_one_is_faint) {
    constexpr std::uint32_t kPasses = 64;
    const SceneDescription scene = seen_from_above({square(0, 0), square(1, 1), square(2, 1)});
    const auto pixels = static_cast<std::size_t>(kPixels * kPixels);
    double sum = 0;
    for (std::uint32_t pass = 0; pass < kPasses; ++pass) {
        const Seen seen = trace(scene, kSampled, 1, {}, pass);
        std::size_t straight = 0;
        for (const VisiblePoint& p : seen.points) {
            sum += static_cast<double>(p.throughput[0]) / static_cast<double>(pixels * kPasses);
            straight += p.disc.bounces == 2 ? 1 : 0;
            if (p.disc.bounces > 2) {
                EXPECT_LT(p.throughput[0], 0.5 / kPiDouble * std::sqrt(kPane) * 1.001);
            }
        }
        EXPECT_EQ(straight, pixels);
    }
    const double passed = (1 - kPane) * (1 - kPane) / (1 - kPane * kPane);
    EXPECT_NEAR(sum / (0.5 / kPiDouble), passed, 0.002);
}

/// Sampled: a glossy surface takes caustics only, and the path goes on. Photons: it ends there.
TEST(CameraPath, glossy_surfaces_gather_and_go_on) {
    SceneDescription scene = seen_from_above({square(0, 2), square(6, 0)});
    const Seen sampled = trace(scene, kSampled);
    int at_metal = 0;
    int beyond = 0;
    for (const VisiblePoint& p : sampled.points) {
        const bool metal = p.disc.position.z == 0;
        ++(metal ? at_metal : beyond);
        EXPECT_EQ(p.disc.kinds, metal ? 2 + 8 : 2 + 4 + 8);
        EXPECT_EQ(p.after_rough, !metal);
        EXPECT_EQ(p.disc.bounces, metal ? 0 : 1);
        EXPECT_EQ(p.bsdf, metal ? 2U : kLambertian);
        EXPECT_EQ(p.disc.normal, Vec3(0, 0, metal ? 1.0F : -1.0F));
    }
    EXPECT_EQ(at_metal, kPixels * kPixels);
    EXPECT_GT(beyond, 20);
    const Seen photons = trace(scene, kPhotons);
    EXPECT_EQ(photons.points.size(), static_cast<std::size_t>(kPixels * kPixels));
    for (const VisiblePoint& p : photons.points) EXPECT_EQ(p.disc.kinds, 15);
}

/// In a mirror discs are as wide as the pixel; in brushed metal wider, by a hundredth of what the
/// lobe is wide: .18 where it is densest, and never more than one. (Pixels off the axis are
/// narrower, by up to .0013.)
TEST(CameraPath, discs_seen_in_a_glossy_lobe_are_a_hundredth_of_it_wider) {
    constexpr double kPixel = 0.3526540 / kPixels;  // 2 tan(10 degrees), at distance one
    for (const float alpha : {0.0F, 0.05F}) {
        SceneDescription scene = seen_from_above({square(0, 2), square(6, 0)});
        std::get<ConductorMaterial>(scene.materials[2]).roughness = {alpha, alpha};
        int beyond = 0;
        for (const VisiblePoint& p : trace(scene, kSampled).points) {
            if (p.disc.position.z == 0) continue;
            ++beyond;
            const double ways = static_cast<double>(p.disc.position.z) / -p.wo.z;
            const double added = p.disc.radius - kPixel * (4 + ways);
            EXPECT_GT(added / ways, alpha > 0 ? 0.0006 : -0.0013);
            EXPECT_LT(added / ways, alpha > 0 ? 0.0102 : 0.0004);
        }
        EXPECT_GT(beyond, 20);
    }
}

/// Through glass too, but not beyond rough metal, whose lobe has made discs wider already.
TEST(CameraPath, discs_are_wider_for_indirect_light_but_beyond_rough_surfaces) {
    CameraPathSettings settings;
    settings.indirect_radius = 3.5;
    const SceneDescription glass = seen_from_above({square(0, 0), square(1, 1)});
    for (const VisiblePoint& p : trace(glass, kSampled, 1, settings).points)
        EXPECT_EQ(p.disc.indirect_radius_scale, 3.5F);
    int beyond = 0;
    const SceneDescription metal = seen_from_above({square(0, 2), square(6, 0)});
    for (const VisiblePoint& p : trace(metal, kSampled, 1, settings).points) {
        EXPECT_EQ(p.disc.indirect_radius_scale, p.after_rough ? 1.0F : 3.5F);
        beyond += p.after_rough ? 1 : 0;
    }
    EXPECT_GT(beyond, 20);
}

TEST(CameraPath, depth_limits_the_eye) {
    const SceneDescription scene = seen_from_above({square(0, 0), square(1, 1)});
    EXPECT_TRUE(trace(scene, {DirectLight::sampled, 0}).points.empty());
    EXPECT_TRUE(trace(scene, {DirectLight::sampled, 1}).points.empty());
    EXPECT_FALSE(trace(scene, {DirectLight::sampled, 2}).points.empty());
}

TEST(CameraPath, the_sky_is_emission) {
    SceneDescription scene = seen_from_above({});
    scene.lights = {InfiniteLight{Spectrum::d65()}};
    const Seen seen = trace(scene, kSampled);
    EXPECT_TRUE(seen.points.empty());
    EXPECT_GT(seen.emission, 0.5 * kPixels * kPixels);
}

// Light, features and throughputs of a flat surface below a camera far away: alike in all pixels,
// whatever their numbers of paths.
TEST(CameraPath, the_paths_of_a_pixel_share_its_light) {
    SceneDescription description = seen_from_above({square(0, 0)});
    description.lights.emplace_back(InfiniteLight{Spectrum::constant(0)});
    const Scene scene(description);
    const PassId id{2, 0};
    const PassScene at(scene, id);
    const std::vector<std::uint8_t> log2_samples = mixed_log2_samples();
    AovSet aovs{};
    aovs.at(static_cast<std::size_t>(Aov::normal)) = true;
    aovs.at(static_cast<std::size_t>(Aov::albedo)) = true;
    PassImage image(kPixels * kPixels, aovs);
    std::vector<std::uint64_t> rays(kPixels * kPixels, 3);
    CameraPass pass{at, kPhotons, {}, {0, 0, kPixels, kPixels}, id};
    pass.log2_samples = log2_samples;
    pass.rays = rays;
    Statistics statistics;
    const auto points = testing_support::joined(trace_camera_paths(pass, image, statistics));
    std::vector<double> throughput(kPixels * kPixels, 0);
    std::vector<std::uint64_t> paths(kPixels * kPixels, 0);
    for (const VisiblePoint& p : points) {
        throughput[p.pixel] += static_cast<double>(p.throughput[0]);
        ++paths[p.pixel];
    }
    for (std::size_t i = 0; i < log2_samples.size(); ++i) {
        EXPECT_EQ(paths[i], 1U << log2_samples[i]);
        EXPECT_EQ(rays[i], 3 + paths[i]);
        EXPECT_NEAR(throughput[i], 0.5 / kPiDouble, 1e-6);
        EXPECT_NEAR(image.value(Aov::normal, i, 2).to_double(), 1, 1e-6);
        EXPECT_NEAR(image.value(Aov::albedo, i, 1).to_double(), 0.5, 1e-3);
    }
    EXPECT_EQ(statistics[Count::camera_paths], points.size());
}

}  // namespace
}  // namespace sunfleck::engine
