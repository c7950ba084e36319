// Direct light at a point against closed forms, for each kind of light; what hides it.
#include "math/warp.h"
#include "support/direct_light_cases.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr double kTolerance = 0.005;

/// The 99% interval of the mean lies within 0.5% of the truth; of nothing, nothing comes.
void expect_irradiance(const LitPoint& point, double irradiance, double tolerance = kTolerance) {
    const double expected = static_cast<double>(kAlbedo) / kPiDouble * irradiance;
    const Interval found = reflected(point);
    if (expected == 0) {
        EXPECT_EQ(found.mean, 0);
        return;
    }
    EXPECT_LT(std::abs(found.mean / expected - 1) + found.half / expected, tolerance)
        << found.mean / expected << " +- " << found.half / expected;
}

class DirectLightOf : public ::testing::TestWithParam<Case> {};

TEST_P(DirectLightOf, has_the_right_mean) {
    SceneDescription scene = floor_of();
    const Case& c = GetParam();
    scene.shapes.insert(scene.shapes.end(), c.shapes.begin(), c.shapes.end());
    scene.lights = c.lights;
    expect_irradiance(LitPoint(std::move(scene)), c.irradiance);
}

const auto kName = [](const auto& info) { return std::string(info.param.name); };
INSTANTIATE_TEST_SUITE_P(Area, DirectLightOf, ::testing::ValuesIn(area_cases()), kName);
INSTANTIATE_TEST_SUITE_P(Mixed, DirectLightOf, ::testing::ValuesIn(mixed_cases()), kName);

/// Light from a point is known exactly: no noise but rounding.
TEST(DirectLight, point_spot_and_distant) {
    const auto expect = [](const Light& light, double irradiance) {
        SceneDescription scene = floor_of();
        scene.lights = {light};
        expect_irradiance(LitPoint(std::move(scene)), irradiance, 1e-5);
    };
    const Spectrum five = Spectrum::constant(5);
    const Vec3d at(1, 1, 3);
    const Vec3d to = at - kPoint;
    const double lit = 5 * to.z / (to.length2() * to.length());
    expect(PointLight{five, at}, lit);
    expect(PointLight{five, {1, 1, -3}}, 0);
    const double cosine = to.z / to.length();  // of the angle to a spot that looks down
    expect(SpotLight{five, at, {0, 0, -1}, cosine - 0.2, cosine - 0.1}, lit);
    const double t = 0.3;  // of the edge, from its dark side
    expect(SpotLight{five, at, {0, 0, -1}, cosine - 0.03, cosine + 0.07},
           lit * t * t * (3 - 2 * t));
    expect(SpotLight{five, at, {0, 0, -1}, cosine + 0.01, cosine + 0.1}, 0);
    expect(DistantLight{five, Vec3d(0.6, 0, -0.8)}, 5 * 0.8);
    expect(DistantLight{five, Vec3d(0.6, 0, 0.8)}, 0);
}

/// Opaque things hide light, up to their rims; what stands beyond the light, or in no way, does
/// not.
TEST(DirectLight, what_hides_it) {
    const Spectrum one = Spectrum::constant(1);
    const std::vector<std::pair<Light, double>> lights = {
        {PointLight{one, kPoint + Vec3d(0, 0, 2)}, 0.25},
        {SpotLight{one, kPoint + Vec3d(0, 0, 2), {0, 0, -1}, 0.5, 0.9}, 0.25},
        {DistantLight{one, {0, 0, -1}}, 1}};
    for (const auto& [light, lit] : lights) {
        const auto expect = [&lamp = light](ShapeDescription shape, double irradiance) {
            SceneDescription scene = floor_of();
            scene.lights = {lamp};
            scene.shapes.push_back(std::move(shape));
            expect_irradiance(LitPoint(std::move(scene)), irradiance, 1e-5);
        };
        const auto plate = [](float x0, float z, std::uint32_t material) {
            return quad({{{x0, -1, z}, {1, -1, z}, {1, 1, z}, {x0, 1, z}}}, material);
        };
        expect(plate(-1, 1, 0), 0);
        expect(plate(-1, 0.001F, 0), 0);
        expect(plate(-1, 1, 3), 0);  // glass: photons bring it
        expect(plate(0.301F, 1, 0), lit);
        expect(plate(-1, 1, 2), lit);
        const bool parallel = std::holds_alternative<DistantLight>(light);
        expect(plate(-1, 2.001F, 0), parallel ? 0 : lit);
        expect(lamp(plate(-1, 1, 0), 0), 0);
    }
}

/// 150 lamps of two triangles, some near, turned this way and that; a sky beside them.
TEST(DirectLight, many_lamps) {
    SceneDescription scene = floor_of();
    RandomStream random(9, Purpose::test, 0, 0);
    double expected = kPiDouble * 0.01;
    for (int i = 0; i < 150; ++i) {
        const Vec3 at(12 * random.next_float() - 6, 12 * random.next_float() - 6,
                      0.5F + 2 * random.next_float());
        const Vec3 along = Vec3(uniform_sphere({random.next(), random.next()})) * 0.2F;
        const Vec3 other(uniform_sphere({random.next(), random.next()}));
        const Vec3 across = along.cross(other).normalized() * 0.2F;
        const Corners corners = {{at, at + along, at + along + across, at + across}};
        ShapeDescription shape = lamp(quad(corners), 1 + 4 * random.next_float());
        shape.unseen = true;  // they do not hide each other
        const double radiance = shape.emission->radiance(550);
        scene.shapes.push_back(shape);
        const Vec3 facing = along.cross(across);
        if (facing.dot(Vec3(kPoint) - at) > 0) expected += radiance * std::abs(of_quad(corners));
    }
    scene.lights = {InfiniteLight{Spectrum::constant(0.01F)}};
    expect_irradiance(LitPoint(std::move(scene)), expected, 0.02);
}

/// A plate between lamp and point hides the half of the lamp with x > 0.3, as seen from there.
TEST(DirectLight, half_hidden_lamp) {
    SceneDescription scene = floor_of();
    scene.shapes.push_back(lamp(quad(kCeiling), kRadiance));
    scene.shapes.push_back(quad({{{.3F, -9, 1}, {9, -9, 1}, {9, 9, 1}, {.3F, 9, 1}}}));
    const Corners seen = {{{-1, -.5F, 2}, {-1, 1.5F, 2}, {.3F, 1.5F, 2}, {.3F, -.5F, 2}}};
    expect_irradiance(LitPoint(std::move(scene)), kRadiance * of_quad(seen), 0.01);
}

/// A Lambertian surface scatters on either side, never through.
TEST(DirectLight, the_side_that_is_looked_at) {
    const Vec3 from_below(-0.6F, 0, 0.8F);
    const Corners cellar = {{{-1, -.5F, -2}, {1, -.5F, -2}, {1, 1.5F, -2}, {-1, 1.5F, -2}}};
    SceneDescription scene = floor_of();
    scene.shapes.push_back(lamp(quad(kCeiling), kRadiance));
    expect_irradiance(LitPoint(scene, from_below), 0);
    scene.shapes.push_back(lamp(quad(cellar), kRadiance / 2));
    expect_irradiance(LitPoint(scene), kRadiance * of_quad(kCeiling));
    expect_irradiance(LitPoint(scene, from_below), kRadiance / 2 * of_quad(kCeiling));
}

TEST(DirectLight, lamp_on_rough_metal) {
    SceneDescription scene = floor_of(1);
    scene.shapes.push_back(lamp(quad(kCeiling), 2));
    const LitPoint point(std::move(scene));
    const double expected = from_lamp(point.vertex(), 2);
    const Interval found = reflected(point);
    EXPECT_LT(std::abs(found.mean / expected - 1) + found.half / expected, 0.005)
        << found.mean / expected << " +- " << found.half / expected;
}

TEST(DirectLight, darkness_costs_nothing) {
    const LitPoint point(floor_of());
    Statistics statistics;
    EXPECT_TRUE(point.by_light({0.5, {0.5, 0.5}, 0.5}, statistics).is_zero());
    EXPECT_EQ(statistics[Count::camera_rays], 0U);
    EXPECT_TRUE(emitter_beyond(point.pass(), Vec3(kPoint), {0, 0, 1}).radiance.is_zero());
    EXPECT_TRUE(point.by_bsdf({0.5F, 0.3F, 0.3F}, statistics).is_zero());
    EXPECT_EQ(statistics[Count::camera_rays], 1U);
}

/// A light sample that cannot reach the camera's side is not traced.
TEST(DirectLight, no_ray_to_what_the_surface_turns_away_from) {
    SceneDescription scene = floor_of();
    scene.lights = {PointLight{Spectrum::constant(1), {0, 0, -1}}};
    const LitPoint point(std::move(scene));
    Statistics statistics;
    EXPECT_TRUE(point.by_light({0.5, {0.5, 0.5}, 0.5}, statistics).is_zero());
    EXPECT_EQ(statistics[Count::camera_rays], 0U);
}

}  // namespace
}  // namespace sunfleck::engine
