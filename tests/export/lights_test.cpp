// Lights are read again as they were, those of ours as what is likest.
#include "export/lights.h"

#include "export/round_trip.h"
#include "math/warp.h"

namespace sunfleck::engine {
namespace {

/// A picture of 2 x 2 colours as a file. @param side  in texels, even.
std::string bytes_of_picture(int side = 2) {
    const std::array<Vec3, 4> colours = {Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(3, 3, 4),
                                         Vec3(0.5F, 0.25F, 0)};
    std::vector<float> texels;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int quarter = (2 * y >= side ? 2 : 0) + (2 * x >= side ? 1 : 0);
            const Vec3& rgb = colours.at(static_cast<std::size_t>(quarter));
            texels.insert(texels.end(), {rgb.x, rgb.y, rgb.z});
        }
    Image image({side, side}, 3, std::move(texels));
    SceneDescription scene = read_world("");
    ImageInfiniteLight light;
    light.curve = Spectrum::d65();
    light.image = std::make_shared<const LightImage>(std::move(image));
    scene.lights.emplace_back(light);
    return files_of(pbrt_scene(scene, "x.pbrt")).at("x-files/environment-1.exr");
}

/// Radiance that a scene's lights send to the origin from a grid of directions.
double difference_of_skies(const SceneDescription& a, const SceneDescription& b) {
    double most = 0;
    const auto radiance = [](const SceneDescription& scene, const Vec3& w) {
        Vec3 sum(0);
        for (const Light& light : scene.lights) {
            const EnvironmentRadiance r = environment_radiance(light, Vec3(0), w);
            sum += r.rgb.value_or(Vec3(1)) * (r.factor * curve(light).luminance());
        }
        return sum;
    };
    for (int i = 0; i < 400; ++i) {
        const Vec3 w(uniform_sphere({(i % 20 + 0.37) / 20, (i / 20 + 0.41) / 20}));
        const Vec3 off = radiance(a, w) - radiance(b, w);
        most = std::max(most, static_cast<double>(off.length()));
    }
    return most;
}

TEST(ExportedLights, are_the_same) {
    const MemoryFiles files = {{"p.exr", bytes_of_picture()}};
    const std::string world = R"(
Camera "orthographic"
WorldBegin
LightSource "point" "rgb I" [ 1 2 3 ] "point3 from" [ 0.1 0.2 0.3 ]
AttributeBegin Translate 1 2 3 Rotate 30 1 1 0
LightSource "spot" "rgb I" [ 5 4 3 ] "point3 to" [ 1 0.5 0 ] "float coneangle" 37
LightSource "distant" "blackbody L" 5000 "point3 from" [ 1 2 3 ] "float scale" 3
LightSource "goniometric" "string filename" "p.exr" "rgb I" [ 1 0.5 0.2 ]
LightSource "projection" "string filename" "p.exr" "float fov" 33 "float scale" 4
LightSource "infinite" "string filename" "p.exr" "float scale" 0.3
AttributeEnd
LightSource "infinite" "rgb L" [ 0.1 0.2 0.4 ]
LightSource "infinite" "point3 portal" [ 0 0 0  0 1 0  1 1 0  1 0 0 ] "rgb L" [ 1 2 1 ]
AreaLightSource "diffuse" "rgb L" [ 3 2 1 ] "bool twosided" true
Shape "sphere"
AreaLightSource "diffuse" "string filename" "p.exr" "float scale" 2 "float power" 30
Shape "disk"
)";
    expect_same_again(world, files);
    const SceneDescription first = read_text(world, files);
    const SceneDescription second = again(first);
    EXPECT_LT(difference_of_skies(first, second), 1e-4);
    EXPECT_TRUE(pbrt_scene(first, "cup.pbrt").warnings.entries().empty());
    const auto& before = std::get<SpotLight>(first.lights.at(1));
    const auto& after = std::get<SpotLight>(second.lights.at(1));
    EXPECT_LT((before.position - after.position).length(), 1e-12);
    EXPECT_LT((before.axis - after.axis).length(), 1e-12);
    EXPECT_NEAR(before.cos_start, after.cos_start, 1e-12);
    const auto& gonio_before = std::get<GoniometricLight>(first.lights.at(3));
    const auto& gonio_after = std::get<GoniometricLight>(second.lights.at(3));
    EXPECT_LT((gonio_before.to_world.y - gonio_after.to_world.y).length(), 1e-12);
    EXPECT_LT((gonio_before.position - gonio_after.position).length(), 1e-12);
    const auto& thrown_before = std::get<ProjectionLight>(first.lights.at(4));
    const auto& thrown_after = std::get<ProjectionLight>(second.lights.at(4));
    EXPECT_NEAR(thrown_before.half.x, thrown_after.half.x, 1e-12);
    EXPECT_LT((thrown_before.to_world.y - thrown_after.to_world.y).length(), 1e-12);
}

/// pbrt-v4 has one kind of edge: another is told, and keeps its power.
TEST(ExportedLights, with_another_soft_edge_keep_their_power) {
    SceneDescription first = read_world("Shape \"sphere\"");
    SpotLight spot{Spectrum::constant(1), Vec3d(0, 0, 3), Vec3d(0, 0, -1), 0.7, 0.9};
    spot.edge = SpotEdge::square;
    first.lights.emplace_back(spot);
    EXPECT_FALSE(pbrt_scene(first, "cup.pbrt").warnings.entries().empty());
    const SceneDescription second = again(first);
    const auto& after = std::get<SpotLight>(second.lights.at(0));
    EXPECT_NEAR(after.power({}), spot.power({}), 1e-9);
    EXPECT_NEAR(after.cos_total, 0.7, 1e-9);
}

TEST(ExportedLights, with_a_sun_have_its_irradiance_and_colour) {
    SceneDescription first = read_world("Shape \"sphere\"");
    SunLight sun;
    sun.curve = Spectrum::rgb_illuminant({30, 25, 20});
    sun.direction = Vec3d(1, -2, -3).normalized();
    sun.versine = 1e-3;
    sun.darkening = normalised_darkening({0.4, 0.6, 0, 0, 0, 0});
    first.lights.emplace_back(sun);
    const SceneDescription second = again(first);
    const SceneSphere sphere;
    const Light& light = second.lights.at(0);
    ASSERT_TRUE(std::holds_alternative<ImageInfiniteLight>(light));
    const double wanted =
        power(first.lights[0], sphere) * static_cast<double>(sun.curve.luminance());
    EXPECT_NEAR(power(light, sphere) * static_cast<double>(curve(light).luminance()), wanted,
                1e-4 * wanted);
    // Within the disc its radiance, beyond it none.
    for (const double radius : {0.0, 0.5, 1.3}) {
        const auto mean_of_ring = [&](const Light& of) {
            double sum = 0;
            for (int i = 0; i < 64; ++i) {
                const SinCos at = sin_cos_2pi(i / 64.0);
                const DiscPoint disc{Vec2d(at.cos, at.sin), 1};
                const Vec3d w =
                    rotate_z_to(-sun.direction, around_pole(disc, sun.versine * radius * radius));
                sum += static_cast<double>(environment_radiance(of, Vec3(0), Vec3(w)).factor *
                                           curve(of).luminance());
            }
            return sum / 64;
        };
        const double before = mean_of_ring(first.lights[0]);
        EXPECT_NEAR(mean_of_ring(light), before, 0.02 * std::max(before, 1.0)) << radius;
    }
    EXPECT_EQ(pbrt_scene(first, "cup.pbrt").warnings.entries().size(), 1U);
    std::get<SunLight>(first.lights[0]).versine = 1e-7;
    EXPECT_TRUE(std::holds_alternative<DistantLight>(again(first).lights.at(0)));
}

TEST(ExportedLights, with_a_spectrum_and_a_picture_look_the_same) {
    SceneDescription first = read_world("Shape \"sphere\"");
    ImageInfiniteLight sky;
    sky.curve = Spectrum(BlackbodySpectrum{9000}).scaled(3);
    sky.image = std::make_shared<const LightImage>(Image(
        {2, 2}, 3, std::vector<float>{1, 1, 1, 0.4F, 0.6F, 0.9F, 0.7F, 2, 1, 0.2F, 0.3F, 0.5F}));
    first.lights.emplace_back(sky);
    const SceneDescription second = again(first);
    const auto colour_of = [](const Light& light, const Vec3& w) {
        const EnvironmentRadiance r = environment_radiance(light, Vec3(0), w);
        const Spectrum factor = Spectrum::rgb_unbounded(r.rgb.value_or(Vec3(1)) * r.factor);
        std::vector<TabulatedSpectrum::Point> product;
        for (int nm = 360; nm <= 830; ++nm) {
            const auto at = static_cast<float>(nm);
            product.push_back({at, factor(at) * curve(light)(at)});
        }
        return Spectrum::table(std::move(product)).to_rgb();
    };
    for (const Vec3& w : {Vec3(1, 1, 0.3F), Vec3(-1, 1, 0.3F), Vec3(1, -1, 0.3F)}) {
        const Vec3 wanted = colour_of(first.lights[0], w.normalized());
        const Vec3 got = colour_of(second.lights[0], w.normalized());
        EXPECT_LT((got - wanted).length(), 0.01F * wanted.length());
    }
}

TEST(ExportedLights, behind_a_portal_are_what_is_seen_through_it) {
    const MemoryFiles files = {{"p.exr", bytes_of_picture(64)}};
    const SceneDescription first = read_world(R"(
LightSource "infinite" "point3 portal" [ 0 0 1  0 1 1  1 1 1  1 0 1 ] "string filename" "p.exr"
Shape "sphere"
)",
                                              files);
    const ExportedScene exported = pbrt_scene(first, "cup.pbrt");
    EXPECT_EQ(exported.warnings.entries().size(), 1U);
    const SceneDescription second = again(first);
    const double before = power(first.lights.at(0), {});
    EXPECT_NEAR(power(second.lights.at(0), {}), before, 0.01 * before);
}

}  // namespace
}  // namespace sunfleck::engine
