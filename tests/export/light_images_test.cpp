// Resampled skies have the light of the given ones.
#include "export/light_images.h"

#include "light/direction_map.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

ImageInfiniteLight sky_of(int rows, const std::function<Vec3(int x, int y)>& colour) {
    std::vector<float> texels;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < 2 * rows; ++x) {
            const Vec3 rgb = colour(x, y);
            texels.insert(texels.end(), {rgb.x, rgb.y, rgb.z});
        }
    ImageInfiniteLight light;
    light.map = DirectionMap::latitude_longitude(rows);
    light.image =
        image_of_directions(Image(Vec2i(2 * rows, rows), 3, std::move(texels)), light.map);
    return light;
}

double mean_of(const Image& image, std::size_t channel) {
    double sum = 0;
    for (int y = 0; y < image.resolution().y; ++y)
        for (int x = 0; x < image.resolution().x; ++x)
            sum += static_cast<double>(image.at(x, y).at(channel));
    return sum / (static_cast<double>(image.resolution().x) * image.resolution().y);
}

TEST(EqualAreaImages, are_even_where_the_sky_is) {
    const auto image = equal_area_image(sky_of(8, [](int, int) { return Vec3(1, 2, 3); }));
    EXPECT_EQ(image->resolution(), Vec2i(16, 16));
    for (int i = 0; i < 16; ++i) {
        EXPECT_NEAR(image->at(i, (5 * i) % 16)[0], 1, 1e-5);
        EXPECT_NEAR(image->at(i, (3 * i) % 16)[2], 3, 1e-5);
    }
}

TEST(EqualAreaImages, have_all_light_of_a_small_sun) {
    const auto light = sky_of(16, [](int x, int y) {
        return x == 11 && y == 5 ? Vec3(1e5F, 9e4F, 7e4F) : Vec3(0.1F, 0.2F, 0.3F);
    });
    const auto image = equal_area_image(light);
    double red = 0;
    for (int y = 0; y < 16; ++y)
        red += light.map.share(y) * (y == 5 ? (1e5 + 31 * 0.1) / 32 : 0.1) / 16;
    EXPECT_NEAR(mean_of(*image, 0), red, 1e-5 * red);
}

TEST(EqualAreaImages, have_their_texels_where_the_sky_has_them) {
    const auto light = sky_of(
        16, [](int x, int y) { return Vec3(static_cast<float>(x), static_cast<float>(y), 1); });
    ImageInfiniteLight made;
    made.image = image_of_directions(*equal_area_image(light), DirectionMap());
    for (const Vec3& w : {Vec3(0.6F, 0.5F, 0.3F), Vec3(-0.3F, 0.8F, -0.5F)}) {
        const Vec3 towards = w.normalized();
        const auto colour = [&](const ImageInfiniteLight& sky) {
            Affine turn;
            ImageInfiniteLight placed = sky;
            placed.to_world = turn;
            const EnvironmentRadiance r = placed.environment_radiance(Vec3(0), towards);
            return *r.rgb * r.factor;
        };
        EXPECT_NEAR(colour(made).x, colour(light).x, 1.01);
        EXPECT_NEAR(colour(made).y, colour(light).y, 1.01);
    }
}

}  // namespace
}  // namespace sunfleck::engine
