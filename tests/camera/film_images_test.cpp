// Images of a point of a spherical film: they show what it shows.
#include "camera/film_images.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace sunfleck::engine {
namespace {

Camera spherical(SphereMap map) {
    SphericalCamera camera;
    camera.resolution = {24, 12};
    camera.map = map;
    return camera;
}

class FilmImages : public ::testing::TestWithParam<SphereMap> {};

TEST_P(FilmImages, have_one_direction) {
    const Camera camera = spherical(GetParam());
    RandomStream random(3, Purpose::test, 0, 0);
    for (int i = 0; i < 1000; ++i) {
        const Vec2d film(24 * random.next(), 12 * random.next());
        const CameraRay ray = camera_ray(camera, film, {});
        for (const Vec2d& image : film_images(camera, film)) {
            const CameraRay other = camera_ray(camera, image, {});
            EXPECT_NEAR(other.direction.dot(ray.direction), 1, 1e-6) << film << " " << image;
        }
    }
}

/// Every point around the film is an image of the one on it that shows the same, once.
TEST_P(FilmImages, are_all_around) {
    const Camera camera = spherical(GetParam());
    RandomStream random(4, Purpose::test, 0, 0);
    std::vector<int> sectors(9);
    for (int i = 0; i < 1000; ++i) {
        const Vec2d film(24 * random.next(), 12 * random.next());
        for (const Vec2d& image : film_images(camera, film)) {
            const Vec2d u(image.x / 24, image.y / 12);
            if (u.x <= -0.5 || u.x >= 1.5 || u.y <= -0.5 || u.y >= 1.5) continue;
            const int column = u.x < 0 ? 0 : u.x < 1 ? 1 : 2;
            const int row = u.y < 0 ? 0 : u.y < 1 ? 1 : 2;
            ++sectors[static_cast<std::size_t>(3 * row + column)];
        }
    }
    // By area: the whole film, halves at its edges, quarters at its corners; 4 standard errors.
    for (std::size_t i = 0; i < 9; ++i) {
        const int expected = i == 4 ? 1000 : i % 2 == 1 ? 500 : 250;
        EXPECT_NEAR(sectors[i], expected, 64) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Maps, FilmImages,
                         ::testing::Values(SphereMap::equal_area, SphereMap::equirectangular));

TEST(FlatFilm, shows_each_point_once) {
    const Camera camera = PerspectiveCamera();
    const FilmPoints images = film_images(camera, {3, 4});
    EXPECT_EQ(std::vector<Vec2d>(images.begin(), images.end()), std::vector<Vec2d>{Vec2d(3, 4)});
}

}  // namespace
}  // namespace sunfleck::engine
