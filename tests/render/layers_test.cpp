// Every class of light path has one owner: the AOVs add up exactly, and each class is the same
// whoever brings it.
#include "support/renders.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using namespace testing_support;  // NOLINT(google-build-using-namespace): a test's own helpers

constexpr std::array<Aov, 4> kLight = {Aov::direct, Aov::caustic, Aov::indirect, Aov::emission};

/// A box with a lamp that the camera sees, a ball of glass, a plate of rough metal and a mirror.
Scene all_classes() {
    return scene_of(
        view("0 -3.8 1  0 0 0.9  0 0 1", 34, 12) + diffuse("0.6 0.6 0.6") +
        "AttributeBegin\nReverseOrientation\n" + box({-1, -4, 0}, {1, 1, 2}) +
        "AttributeEnd\nAttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [8 8 8]\n" +
        quad("-.5 .3 1.98  .5 .3 1.98  .5 -.7 1.98  -.5 -.7 1.98") + "AttributeEnd\n" +
        "AttributeBegin\nMaterial \"dielectric\"\nTranslate 0.4 -0.3 0.5\n" +
        "Shape \"sphere\" \"float radius\" 0.45\nAttributeEnd\n" +
        "Material \"conductor\" \"float roughness\" 0.2\n" +
        quad("-.9 .5 .2  -.3 .9 .2  -.3 .9 1.2  -.9 .5 1.2") + "Material \"conductor\"\n" +
        quad("-.9 -.6 .01  -.2 -.6 .01  -.2 .2 .01  -.9 .2 .01"));
}

RenderSettings settings_for(DirectLight direct) {
    RenderSettings settings;
    settings.transport.direct = direct;
    settings.transport.indirect = IndirectLight::photons;
    settings.transport.max_depth = 12;
    settings.photon.paths_per_pass = 20'000;
    settings.camera.radius_pixels = 0.5;
    settings.aovs.fill(true);
    settings.seed = 3;
    return settings;
}

FixedPoint sum_of_aovs(const PassImage& image, std::size_t pixel, std::size_t channel) {
    FixedPoint sum;
    for (const Aov aov : kLight) sum += image.value(aov, pixel, channel);
    return sum;
}

/// A channel of the pixels of a photon cell.
class CellLight {
public:
    CellLight(const PassImage& image, const BlockGrid& cells, std::size_t cell, std::size_t channel)
        : image_(image), cells_(cells), cell_(cell), channel_(channel) {}

    FixedPoint sum(Aov aov) const {
        FixedPoint sum;
        cells_.for_pixels(cell_,
                          [&](std::size_t pixel) { sum += image_.value(aov, pixel, channel_); });
        return sum;
    }
    FixedPoint by_photons() const { return image_.by_photons(cell_, channel_); }
    /// Of the total, what photons have not brought.
    double by_camera() const {
        FixedPoint rest = sum(Aov::total);
        rest += -by_photons();
        return rest.to_double();
    }

private:
    const PassImage& image_;
    const BlockGrid& cells_;
    std::size_t cell_;
    std::size_t channel_;
};

class Aovs : public ::testing::TestWithParam<DirectLight> {};

/// Discs, and their bias, are of photons alone (film/bias.h): the rest knows nothing of them.
TEST_P(Aovs, what_camera_paths_bring_does_not_depend_on_photons) {
    const Scene scene = all_classes();
    RenderSettings settings = settings_for(GetParam());
    settings.photon.adaptive_pixels =
        false;  // how many camera paths there are may depend on photons
    const PassResult many = render_pass(scene, settings, 2);
    settings.photon.paths_per_pass = 500;
    settings.camera.radius_pixels = 3;
    const PassResult few = render_pass(scene, settings, 2);
    bool differs = false;
    const PixelWindow window = window_of(scene.film());
    const BlockGrid cells = photon_cells_of(window.width(), window.height());
    for (std::size_t cell = 0; cell < cells.count(); ++cell)
        for (std::size_t c = 0; c < 3; ++c) {
            const CellLight of_many(many.image, cells, cell, c);
            const CellLight of_few(few.image, cells, cell, c);
            const double camera = of_many.by_camera();
            EXPECT_EQ(camera, of_few.by_camera()) << cell;
            differs = differs || !(of_many.by_photons() == of_few.by_photons());
            const double emission = of_many.sum(Aov::emission).to_double();
            const double direct = of_many.sum(Aov::direct).to_double();
            if (GetParam() == DirectLight::photons)
                EXPECT_EQ(camera, emission) << cell;
            else
                EXPECT_GE(camera, (emission + direct) * (1 - 1e-12)) << cell;
        }
    EXPECT_TRUE(differs);
}

TEST_P(Aovs, add_up_to_the_picture_exactly) {
    const Scene scene = all_classes();
    for (const std::uint32_t number : {0U, 5U}) {
        const PassResult pass = render_pass(scene, settings_for(GetParam()), number);
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < pass.image.pixels(); ++i)
                ASSERT_EQ(sum_of_aovs(pass.image, i, c), pass.image.value(Aov::total, i, c));
        for (const Aov aov : kLight) {
            double seen = 0;
            for (std::size_t i = 0; i < pass.image.pixels(); ++i)
                seen += luminance(pixel_value(pass.image, i, aov));
            EXPECT_GT(seen, 0.05);
        }
    }
}

/// With one scattering event there is nothing but emission and direct light; with none, emission.
TEST_P(Aovs, depth_cuts_classes_off) {
    const Scene scene = all_classes();
    RenderSettings settings = settings_for(GetParam());
    const auto sum = [&](Aov aov) {
        return luminance(render_mean(scene, settings, 2, aov).mean());
    };
    settings.transport.max_depth = 1;
    EXPECT_EQ(sum(Aov::caustic), 0);
    EXPECT_EQ(sum(Aov::indirect), 0);
    EXPECT_GT(sum(Aov::direct), 0.01);
    settings.transport.max_depth = 0;
    EXPECT_EQ(sum(Aov::direct), 0);
    EXPECT_GT(sum(Aov::emission), 0.01);
    EXPECT_EQ(sum(Aov::emission), sum(Aov::total));
}

INSTANTIATE_TEST_SUITE_P(Direct, Aovs,
                         ::testing::Values(DirectLight::sampled, DirectLight::photons),
                         [](const auto& way) {
                             return way.param == DirectLight::sampled ? "sampled" : "photons";
                         });

/// Classes alone, on a floor that cannot light itself.
TEST(LayersAlone, a_bare_floor_has_direct_light_and_a_covered_one_caustics) {
    const std::string floor = view("0 -3 2  0 0 0  0 0 1", 20, 8) +
                              "LightSource \"point\" \"point3 from\" [0 0 3] \"float scale\" 10\n" +
                              diffuse("0.5 0.5 0.5") + quad("-3 -3 0  3 -3 0  3 3 0  -3 3 0");
    RenderSettings settings = settings_for(DirectLight::sampled);
    settings.photon.sampler = PhotonSampler::uniform;
    const auto sum = [&](const Scene& scene, Aov aov) {
        return luminance(render_mean(scene, settings, 4, aov).mean());
    };
    const Scene bare = scene_of(floor);
    EXPECT_EQ(sum(bare, Aov::caustic), 0);
    EXPECT_EQ(sum(bare, Aov::indirect), 0);
    EXPECT_EQ(sum(bare, Aov::emission), 0);
    EXPECT_EQ(sum(bare, Aov::direct), sum(bare, Aov::total));

    // Under a wide plate of glass that hides the lamp, all light of the floor came through glass.
    const Scene covered =
        scene_of(floor + "Material \"dielectric\"\n" + box({-3, -3, 1.5}, {3, 3, 1.7}));
    EXPECT_EQ(sum(covered, Aov::direct), 0);
    EXPECT_EQ(sum(covered, Aov::emission), 0);
    EXPECT_GT(sum(covered, Aov::caustic), 0.8 * sum(bare, Aov::direct));
    EXPECT_GT(sum(covered, Aov::indirect), 0);  // floor, glass, floor
}

}  // namespace
}  // namespace sunfleck::engine
