// Skies and projectors with pictures in whole renders, by photons, by sampling and by the reference
// path tracers.
#include "core/parallel.h"
#include "image/image_files.h"
#include "import/pbrt/scene_text.h"
#include "math/warp.h"
#include "support/renders.h"

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

enum class Way { photons, sampled, path, bdpt };

RenderSettings settings_for(Way way) {
    RenderSettings settings;
    settings.integrator = way == Way::path   ? Integrator::path
                          : way == Way::bdpt ? Integrator::bdpt
                                             : Integrator::sppm;
    settings.transport.direct = way == Way::photons ? DirectLight::photons : DirectLight::sampled;
    settings.photon.sampler = PhotonSampler::uniform;
    settings.photon.paths_per_pass = way == Way::photons ? 20'000 : 100;
    settings.seed = 5;
    return settings;
}

/// Eight by eight texels, all black but the sun at (4, 3): around 45 degrees, x > 0 > y, above.
std::string sun_file(const Vec3& colour) {
    std::vector<float> texels(std::size_t{3} * 8 * 8, 0.0F);
    for (int c = 0; c < 3; ++c)
        texels[static_cast<std::size_t>(((7 - 3) * 8 + 4) * 3 + c)] = colour[c];
    return pfm_file("PF\n8 8\n-1\n", texels, true);
}

const MemoryFiles kFiles = {
    {"white.pfm", pfm_file("PF\n4 4\n-1\n", std::vector<float>(48, 1), true)},
    {"black.pfm", pfm_file("PF\n2 2\n-1\n", std::vector<float>(12, 0), true)},
    {"sun.pfm", sun_file({40, 40, 40})},
    {"slide.pfm", pfm_file("PF\n2 2\n-1\n", {30, 30, 30, 90, 90, 90, 0, 0, 0, 60, 30, 15}, true)},
    {"gold.pfm", sun_file({40, 20, 5})}};

/// A floor seen from above, of reflectance 1/2.
Scene floor_under(const std::string& sky, const std::string& more = "") {
    const std::string text = "Scale -1 1 1\n" + view("0 0 100  0 0 0  0 1 0", 1, 8) + sky +
                             diffuse(".5 .5 .5") + quad("-2 -2 0  2 -2 0  2 2 0  -2 2 0") + more;
    return Scene(read_pbrt_text(text, "test.pbrt", memory_access(kFiles)));
}

std::string picture(const std::string& name) {
    return "LightSource \"infinite\" \"string filename\" \"" + name + ".pfm\"\n";
}

/// Irradiance over radiance on the floor of one texel of the sky: midpoints.
double sun_on_floor(const Matrix& turn) {
    constexpr int kFine = 500;
    double sum = 0;
    for (int y = 0; y < kFine; ++y)
        for (int x = 0; x < kFine; ++x) {
            Vec3d w;
            turn.multDirMatrix(
                uniform_sphere({(4 + (x + 0.5) / kFine) / 8, (3 + (y + 0.5) / kFine) / 8}), w);
            sum += std::max(0.0, w.z);
        }
    return sum / (kFine * kFine) * 4 * kPiDouble / 64;
}

class ImageLights : public ::testing::TestWithParam<Way> {
protected:
    Vec3d floor_value(const Scene& scene, std::uint32_t passes) const {
        return render_mean(scene, settings_for(GetParam()), passes).mean(1, 1, 7, 7);
    }
};

TEST_P(ImageLights, a_texel_lights_the_floor_by_its_solid_angle) {
    const Vec3d seen = floor_value(floor_under(picture("sun")), 32);
    const double expected = 0.5 / kPiDouble * 40 * sun_on_floor(Matrix());
    EXPECT_GT(expected, 0.5);
    EXPECT_NEAR(luminance(seen), expected, 0.03 * expected);
}

TEST_P(ImageLights, turn_with_their_matrix) {
    Matrix turn;
    turn.rotate(Vec3d(kPiDouble / 3, 0, 0));
    const Vec3d seen = floor_value(
        floor_under("AttributeBegin Rotate 60 1 0 0\n" + picture("sun") + "AttributeEnd\n"), 32);
    const double expected = 0.5 / kPiDouble * 40 * sun_on_floor(turn);
    EXPECT_NEAR(luminance(seen), expected, 0.03 * expected);
}

TEST_P(ImageLights, keep_their_colour) {
    const Vec3d seen = floor_value(floor_under(picture("gold")), 64);
    const double grey = 0.5 / kPiDouble * sun_on_floor(Matrix());
    EXPECT_NEAR(seen.x, 40 * grey, 0.05 * 40 * grey);
    EXPECT_NEAR(seen.y, 20 * grey, 0.05 * 20 * grey);
    EXPECT_NEAR(seen.z, 5 * grey, 0.08 * 5 * grey);
}

/// Light samples and rays that leave are those of a sky of one radiance, bit by bit; photons start
/// elsewhere, and agree in the mean.
TEST_P(ImageLights, of_one_value_are_a_sky_without_a_picture) {
    const std::string ball =
        "Material \"dielectric\"\nTranslate 0 0 .5 Shape \"sphere\" \"float radius\" .3\n";
    const Scene plain = floor_under("LightSource \"infinite\"\n", ball);
    const Scene painted = floor_under(picture("white"), ball);
    if (GetParam() == Way::path) {
        EXPECT_EQ(render_mean(painted, settings_for(Way::path), 4).rgb,
                  render_mean(plain, settings_for(Way::path), 4).rgb);
        return;
    }
    RenderSettings settings = settings_for(GetParam());
    settings.photon.paths_per_pass = 5'000;
    const auto value = [&](const Scene& scene) {
        return Estimate::over(6, [&](int i) {
            settings.seed = static_cast<std::uint64_t>(i);
            return luminance(render_mean(scene, settings, 16).mean());
        });
    };
    EXPECT_LT(worst_ratio(value(painted), value(plain)), 0.06);
}

/// From height 4 straight down over the view of [-1,1]^2, turned about x: its top is at y = -1.
/// (Discs of photons reach over the edges of texels.)
TEST_P(ImageLights, project_their_picture) {
    const Scene scene = floor_under(
        "AttributeBegin Translate 0 0 4 Rotate 180 1 0 0\nLightSource \"projection\" \"string "
        "filename\" \"slide.pfm\" \"float fov\" 28.0724869\nAttributeEnd\n");
    const MeanPicture picture = render_mean(scene, settings_for(GetParam()), 64);
    // Mean of cos / distance^2 over the pixels 1 to 2 of 8 (x and y), from the axis.
    double share = 0;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const Vec3d way(0.25 + (x + 0.5) / 200, 0.25 + (y + 0.5) / 200, 4);
            share += 0.5 / kPiDouble * 4 / (way.length2() * way.length()) / 10000;
        }
    const auto expect = [&](int x, int y, const Vec3d& intensity) {
        const Vec3d seen = picture.mean(x, y, x + 2, y + 2);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(seen[c], intensity[c] * share, (0.06 * intensity[c] + 0.6) * share)
                << x << ' ' << y;
    };
    expect(1, 1, {30, 30, 30});
    expect(5, 1, {90, 90, 90});
    expect(1, 5, {0, 0, 0});
    expect(5, 5, {60, 30, 15});
}

TEST_P(ImageLights, of_black_are_no_light) {
    const Scene dark = floor_under(picture("black"));
    EXPECT_EQ(floor_value(dark, 1), Vec3d(0));
    EXPECT_FALSE(dark.warnings().entries().empty());
}

INSTANTIATE_TEST_SUITE_P(Skies, ImageLights,
                         ::testing::Values(Way::photons, Way::sampled, Way::path, Way::bdpt),
                         [](const auto& way) {
                             return way.param == Way::photons   ? "photons"
                                    : way.param == Way::sampled ? "sampled"
                                    : way.param == Way::bdpt    ? "bdpt"
                                                                : "path";
                         });

TEST(ImageLightBytes, are_the_same_with_any_number_of_threads) {
    const Scene scene = floor_under(picture("gold"));
    RenderSettings settings = settings_for(Way::photons);
    settings.photon.sampler = PhotonSampler::adaptive;
    settings.photon.paths_per_pass = 2'000;
    const auto render = [&](std::size_t threads) {
        const ThreadLimit limit(threads);
        return render_mean(scene, settings, 4).rgb;
    };
    EXPECT_EQ(render(1), render(4));
}

}  // namespace
}  // namespace sunfleck::engine
