// Environment pictures: where their pixels are seen.
#include "sky/environment.h"

#include "image/exr.h"
#include "image/temporary_folder.h"
#include "sky/compass.h"
#include "sunfleck/error.h"

namespace sunfleck::engine {
namespace {

class Environment : public testing_support::TemporaryFolder {
protected:
    /// The light of a picture of 8 x 4 pixels that is bright at one of them.
    ImageInfiniteLight lit_at(int x, int y, const Affine& axes, double scale = 1) const {
        Picture picture;
        picture.width = 8;
        picture.height = 4;
        for (const char* name : {"R", "G", "B"})
            picture.add(name).values[static_cast<std::size_t>(8 * y + x)] = 5;
        write_exr(path("sky.exr"), picture);
        SceneDescription scene;
        add_environment(scene, {path("sky.exr"), scale}, axes);
        EXPECT_EQ(scene.files, std::vector<std::string>{path("sky.exr")});
        return std::get<ImageInfiniteLight>(scene.lights.at(0));
    }

    static float seen(const ImageInfiniteLight& light, const Vec3d& w) {
        return light.environment_radiance(Vec3(0), Vec3(w.normalized())).factor;
    }
};

TEST_F(Environment, has_east_in_its_middle_and_north_to_the_left) {
    const Affine axes = compass(UpAxis::z, 0);
    const ImageInfiniteLight east = lit_at(4, 1, axes);
    EXPECT_EQ(seen(east, {1, -0.2, 0.3}), 5);
    EXPECT_EQ(seen(east, {1, 0.2, 0.3}), 0);
    EXPECT_EQ(seen(east, {1, -0.2, -0.3}), 0);
    const ImageInfiniteLight north = lit_at(2, 1, axes);
    EXPECT_EQ(seen(north, {0.2, 1, 0.3}), 5);
    EXPECT_EQ(seen(lit_at(2, 1, compass(UpAxis::y, 0)), {0.2, 0.3, -1}), 5);
    EXPECT_EQ(lit_at(2, 1, axes, 3).curve.luminance(), 3 * north.curve.luminance());
}

/// A turn of north by 45 degrees is a pixel of eight.
TEST_F(Environment, turns_as_its_pixels_do) {
    const ImageInfiniteLight turned = lit_at(2, 1, compass(UpAxis::z, 45));
    const ImageInfiniteLight moved = lit_at(3, 1, compass(UpAxis::z, 0));
    for (double x = -0.95; x < 1; x += 0.3)
        for (double y = -0.85; y < 1; y += 0.3)
            for (const double z : {-0.4, 0.1, 0.4})
                EXPECT_EQ(seen(turned, {x, y, z}), seen(moved, {x, y, z})) << x << ' ' << y;
}

TEST_F(Environment, of_another_shape_is_refused) {
    Picture picture;
    picture.width = 3;
    picture.height = 2;
    for (const char* name : {"R", "G", "B"}) picture.add(name);
    write_exr(path("odd.exr"), picture);
    SceneDescription scene;
    EXPECT_THROW(add_environment(scene, {path("odd.exr"), 1}, Affine()), Error);
    EXPECT_THROW(add_environment(scene, {path("none.exr"), 1}, Affine()), Error);
}

}  // namespace
}  // namespace sunfleck::engine
