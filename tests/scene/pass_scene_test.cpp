// The scene of a pass where area lights have pictures: what a ray meets is what direct samples
// promise, texel by texel, and pictures stand upright.
#include "scene/pass_scene.h"

#include "core/random.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// Rows from the top: red above blue at the left, green above white at the right.
std::shared_ptr<const SurfacePicture> four_texels() {
    return std::make_shared<const SurfacePicture>(
        Image({2, 2}, 3, std::vector<float>{8, 0, 0, 0, 4, 0, 0, 0, 2, 1, 1, 1}));
}

ShapeDescription pictured(Shape shape, const Matrix& to_world = {}, bool two_sided = true) {
    AreaEmission emission{Spectrum::d65().scaled(3), two_sided, 0, four_texels()};
    return {{std::move(shape), to_world, false}, 0, emission, {}};
}

Scene scene_of(ShapeDescription shape) {
    SceneDescription description;
    description.materials = {DiffuseMaterial{Spectrum::constant(0.5F)}};
    description.shapes = {std::move(shape)};
    return Scene(std::move(description));
}

/// Two triangles over [0,2] x [0,1], (u, v) from (0, 0) to (1, 1).
TriangleMesh panel() {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    return mesh;
}

BilinearMesh twisted() {
    BilinearMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0.4F}, {0.2F, 1, 0.3F}, {1, 1, -0.2F}};
    mesh.patches = {{0, 1, 2, 3}};
    mesh.uvs = {{0.2F, 0}, {1, 0.1F}, {0, 1}, {0.9F, 0.8F}};
    return mesh;
}

/// The colour seen along the ray, in linear sRGB, mean over many passes' wavelengths.
Vec3 seen(const Scene& scene, const Vec3& origin, const Vec3& direction) {
    Vec3 sum(0);
    constexpr int kPasses = 64;
    for (std::uint32_t i = 0; i < kPasses; ++i) {
        const PassScene pass(scene, {1, i});
        const Hit hit = scene.geometry().intersect({origin, direction}).value();
        const std::uint32_t index = scene.light_of(hit);
        const auto& light = std::get<AreaLight>(scene.lights()[index]);
        sum += pass.wavelengths.to_rgb(pass.emitted(index, light, hit)) / float{kPasses};
    }
    return sum;
}

TEST(PicturedLights, stand_upright) {
    const Scene scene = scene_of(pictured(panel()));
    const auto expect = [&](const Vec2& place, const Vec3& rgb) {
        const Vec3 found = seen(scene, {place.x, place.y, 1}, {0, 0, -1});
        EXPECT_NEAR((found - rgb * 3).length(), 0, 0.02F * rgb.length()) << place << found;
    };
    expect({0.2F, 0.9F}, {8, 0, 0});
    expect({1.8F, 0.9F}, {0, 4, 0});
    expect({0.2F, 0.1F}, {0, 0, 2});
    expect({1.8F, 0.1F}, {1, 1, 1});
    expect({1, 0.1F}, {0.5F, 0.5F, 1.5F});  // between two texels
}

/// Sees 1% of the radiance of any sample.
TEST(PicturedLights, direct_samples_bring_what_rays_meet) {
    Matrix place;
    place.translate(Vec3d(0.3, 0.4, -1));
    place.rotate(Vec3d(0.4, 0.2, 0.1));
    Matrix uneven = place;
    uneven.scale(Vec3d(1, 0.7, 1.4));
    Cylinder half;
    half.phi_max = 3;
    Disk ring;
    ring.inner_radius = 0.3;
    const std::vector<ShapeDescription> all = {
        pictured(panel()),          pictured(twisted(), uneven), pictured(Sphere{}, place),
        pictured(Sphere{}, uneven), pictured(half, uneven),      pictured(ring, place)};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Scene scene = scene_of(all[i]);
        const PassScene pass(scene, {1, 0});
        const Vec3 point(0.7F, 0.1F, 1.5F);
        RandomStream random(2, Purpose::test, 0, static_cast<std::uint32_t>(i));
        int tested = 0;
        for (int k = 0; k < 2000; ++k) {
            const std::uint32_t index =
                static_cast<std::uint32_t>(k) % static_cast<std::uint32_t>(scene.lights().size());
            const auto& light = std::get<AreaLight>(scene.lights()[index]);
            const Vec2 u(random.next_float(), random.next_float());
            const auto s = light.sample_direct(point, u, {});
            const auto hit = s ? scene.geometry().intersect({point, s->direction}) : std::nullopt;
            if (!hit || std::abs(hit->distance - s->distance) > 1e-4F) continue;  // behind itself
            const SampledSpectrum met = pass.emitted(index, light, *hit);
            const SampledSpectrum promised =
                pass.tinted(pass.emission[index] * (s->factor * *s->pdf), s->tint);
            if (std::abs(hit->uv.x - 0.5F) > 0.49F) continue;  // at the seam
            ASSERT_NEAR(met.sum(), promised.sum(), 0.01F * promised.sum()) << i << ' ' << hit->uv;
            ++tested;
        }
        EXPECT_GT(tested, 300) << i;
    }
}

/// The panel's light is shared by its triangles as the picture has it; both sides count.
TEST(PicturedLights, have_the_power_of_the_picture) {
    const Scene scene = scene_of(pictured(panel()));
    double sum = 0;
    for (const Light& light : scene.lights()) sum += power(light, scene.sphere());
    const double mean = (8 * 0.2126 + 4 * 0.7152 + 2 * 0.0722 + 1) / 4;
    EXPECT_NEAR(sum, 2 * kPiDouble * 2 * mean, 1e-3 * sum);
    // The lower right triangle holds more than half of the white texel, not of the red one.
    EXPECT_LT(power(scene.lights()[0], scene.sphere()), 0.55 * sum);
    ShapeDescription given = pictured(Sphere{}, {}, false);
    given.emission->power = 7;
    const Scene sphere = scene_of(given);
    EXPECT_NEAR(curve(sphere.lights()[0]).luminance(), 3 * 7 / (kPi * 4 * kPi * float(mean)), 1e-3);
}

/// Photons carry the same luminance within 20% but for a few, from all of the light.
TEST(PicturedLights, send_photons_from_where_they_are_bright) {
    std::vector<float> texels(256, 0.0F);
    texels[7 * 16 + 5] = 100;
    texels[2 * 16 + 12] = 300;
    AreaEmission emission{Spectrum::d65(), false, 0,
                          std::make_shared<const SurfacePicture>(Image({16, 16}, 1, texels))};
    const Scene scene = scene_of({{panel(), {}, false}, 0, emission, {}});
    double sum = 0;
    double squares = 0;
    RandomStream random(3, Purpose::test, 0, 0);
    constexpr int kSamples = 20000;
    const double total = scene.light_choice().total();
    for (int i = 0; i < kSamples; ++i) {
        const auto choice = scene.light_choice().choose(random.next());
        const Emission e = sample_emission(
            scene.lights()[choice.index],
            {random.next(), random.next(), random.next(), random.next()}, scene.sphere());
        const double flux = e.factor / choice.probability / total;
        sum += flux;
        squares += flux * flux;
    }
    EXPECT_NEAR(sum / kSamples, 1, 0.01);
    EXPECT_LT(squares / kSamples - 1, 0.15);  // 40 and more by area
}

}  // namespace
}  // namespace sunfleck::engine
