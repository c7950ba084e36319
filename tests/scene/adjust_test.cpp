// Another picture size or crop from the command line: what of the view is kept.
#include "scene/adjust.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using Crop = std::array<int, 4>;

/// 200 x 100 pixels, the screen off centre: x in [-1, 3], y in [-0.5, 1.5].
SceneDescription wide_scene() {
    SceneDescription scene;
    scene.film.resolution = Vec2i(200, 100);
    PerspectiveCamera camera;
    camera.resolution = scene.film.resolution;
    camera.screen_min = {-1, -0.5};
    camera.screen_max = {3, 1.5};
    scene.camera = camera;
    return scene;
}

const PerspectiveCamera& camera_of(const SceneDescription& scene) {
    return std::get<PerspectiveCamera>(scene.camera);
}

void expect_screen(const SceneDescription& scene, const Vec2d& low, const Vec2d& high) {
    EXPECT_NEAR(camera_of(scene).screen_min.x, low.x, 1e-12);
    EXPECT_NEAR(camera_of(scene).screen_min.y, low.y, 1e-12);
    EXPECT_NEAR(camera_of(scene).screen_max.x, high.x, 1e-12);
    EXPECT_NEAR(camera_of(scene).screen_max.y, high.y, 1e-12);
}

/// Rough metals and glass, and no coated one.
TEST(Adjust, energy_compensation_reaches_the_materials) {
    SceneDescription scene;
    const auto eta = Spectrum::constant(1.5F);
    const ConductorMaterial metal{eta, eta, {}, {0.2F, 0.2F}};
    scene.materials = {metal, DielectricMaterial{eta, {0.2F, 0.2F}},
                       CoatedConductorMaterial{metal, nullptr}};
    EXPECT_EQ(std::get<ConductorMaterial>(scene.materials[0]).roughness.losses(), nullptr);
    compensate_energy(scene);
    EXPECT_NE(std::get<ConductorMaterial>(scene.materials[0]).roughness.losses(), nullptr);
    EXPECT_NE(std::get<DielectricMaterial>(scene.materials[1]).roughness.losses(), nullptr);
    EXPECT_EQ(std::get<CoatedConductorMaterial>(scene.materials[2]).metal.roughness.losses(),
              nullptr);
}

TEST(Adjust, the_same_shape_of_picture_keeps_the_view) {
    SceneDescription scene = wide_scene();
    set_resolution(scene, {50, 25});
    EXPECT_EQ(scene.film.resolution, Vec2i(50, 25));
    EXPECT_EQ(camera_of(scene).resolution, Vec2i(50, 25));
    EXPECT_EQ(camera_of(scene).screen_min, Vec2d(-1, -0.5));
    EXPECT_EQ(camera_of(scene).screen_max, Vec2d(3, 1.5));
    EXPECT_FALSE(scene.film.crop);
}

/// A window that the scene stretches stays stretched when the picture keeps its shape.
TEST(Adjust, the_same_shape_keeps_pixels_that_are_not_square) {
    SceneDescription scene = wide_scene();
    std::get<PerspectiveCamera>(scene.camera).screen_max = {7, 1.5};
    set_resolution(scene, {400, 200});
    expect_screen(scene, {-1, -0.5}, {7, 1.5});
}

/// The screen's shorter side is 2, its centre (1, 0.5): both stay, and pixels are square.
TEST(Adjust, another_shape_keeps_the_shorter_side_and_the_centre) {
    struct Case {
        Vec2i resolution;
        Vec2d half;
    };
    for (const Case& c : {Case{{64, 64}, {1, 1}}, Case{{30, 90}, {1, 3}}, Case{{400, 100}, {4, 1}},
                          Case{{100, 200}, {1, 2}}, Case{{201, 100}, {2.01, 1}}}) {
        SCOPED_TRACE(c.resolution.x);
        SceneDescription scene = wide_scene();
        set_resolution(scene, c.resolution);
        EXPECT_EQ(scene.film.resolution, c.resolution);
        EXPECT_EQ(camera_of(scene).resolution, c.resolution);
        expect_screen(scene, Vec2d(1, 0.5) - c.half, Vec2d(1, 0.5) + c.half);
    }
}

/// 60000 * 40000 is more than an int holds.
TEST(Adjust, large_pictures) {
    SceneDescription scene = wide_scene();
    scene.film.resolution = {40000, 1000};
    scene.film.crop = Crop{20000, 40000, 0, 1000};
    std::get<PerspectiveCamera>(scene.camera).screen_min = {-40, -1};
    std::get<PerspectiveCamera>(scene.camera).screen_max = {40, 1};
    set_resolution(scene, {60000, 1500});
    expect_screen(scene, {-40, -1}, {40, 1});
    EXPECT_EQ(scene.film.crop, (Crop{30000, 60000, 0, 1500}));
}

TEST(Adjust, a_crop_keeps_its_share) {
    SceneDescription scene = wide_scene();
    scene.film.crop = Crop{50, 200, 0, 75};
    set_resolution(scene, {400, 40});
    EXPECT_EQ(scene.film.crop, (Crop{100, 400, 0, 30}));
}

/// Neighbours tile the smaller picture as they did the larger: no pixel twice, none left out.
TEST(Adjust, crops_that_touch_go_on_touching) {
    std::vector<Crop> crops;
    for (const Crop& crop : {Crop{0, 67, 0, 100}, Crop{67, 133, 0, 100}, Crop{133, 200, 0, 100}}) {
        SceneDescription scene = wide_scene();
        scene.film.crop = crop;
        set_resolution(scene, {31, 17});
        crops.push_back(*scene.film.crop);
    }
    EXPECT_EQ(crops[0][0], 0);
    EXPECT_EQ(crops[0][1], crops[1][0]);
    EXPECT_EQ(crops[1][1], crops[2][0]);
    EXPECT_EQ(crops[2][1], 31);
}

/// Each pixel of the larger picture becomes the one that covers it, never none.
TEST(Adjust, a_small_crop_keeps_a_pixel) {
    for (int x = 0; x < 200; ++x) {
        SceneDescription scene = wide_scene();
        scene.film.crop = Crop{x, x + 1, 98, 99};
        set_resolution(scene, {7, 9});
        const int left = x * 7 / 200;
        EXPECT_EQ((*scene.film.crop)[0], left);
        EXPECT_EQ((*scene.film.crop)[1], left + 1);
        EXPECT_EQ((*scene.film.crop)[2], 8);
        EXPECT_EQ((*scene.film.crop)[3], 9);
    }
}

TEST(Adjust, a_new_crop_replaces_the_old) {
    SceneDescription scene = wide_scene();
    scene.film.crop = Crop{0, 10, 0, 10};
    set_crop(scene, {20, 21, 30, 100}, "--crop");
    EXPECT_EQ(scene.film.crop, (Crop{20, 21, 30, 100}));
    set_crop(scene, {0, 200, 0, 100}, "--crop");
    EXPECT_EQ(scene.film.crop, (Crop{0, 200, 0, 100}));
    EXPECT_EQ(scene.film.resolution, Vec2i(200, 100));
    expect_screen(scene, {-1, -0.5}, {3, 1.5});
}

TEST(Adjust, a_window_takes_the_pixels_that_pbrt_takes) {
    EXPECT_EQ(pixels_of_window({0, 1, 0, 1}, {7, 5}), (Crop{0, 7, 0, 5}));
    EXPECT_EQ(pixels_of_window({0.25, 0.75, 0.4, 1}, {16, 12}), (Crop{4, 12, 5, 12}));
    EXPECT_EQ(pixels_of_window({0.75, 0.25, -1, 2}, {16, 12}), (Crop{4, 12, 0, 12}));
}

TEST(Adjust, a_crop_that_is_no_part_of_the_picture_is_an_error) {
    for (const Crop& crop :
         {Crop{10, 10, 0, 5}, Crop{0, 5, 10, 10}, Crop{11, 10, 0, 5}, Crop{200, 300, 0, 5},
          Crop{-9, 0, 0, 5}, Crop{0, 5, 100, 101}, Crop{-1, 200, 0, 100}, Crop{0, 201, 0, 100},
          Crop{0, 200, -1, 100}, Crop{0, 200, 0, 101}}) {
        SceneDescription scene = wide_scene();
        scene.film.crop = Crop{1, 2, 3, 4};
        try {
            set_crop(scene, crop, "--crop");
            ADD_FAILURE() << crop[0] << ' ' << crop[1] << ' ' << crop[2] << ' ' << crop[3];
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()),
                      "--crop: is no part of the picture; give x0,x1,y0,y1 in pixels, with 0 <= "
                      "x0 < x1 <= 200 and 0 <= y0 < y1 <= 100");
        }
        EXPECT_EQ(scene.film.crop, (Crop{1, 2, 3, 4}));
    }
}

}  // namespace
}  // namespace sunfleck::engine
