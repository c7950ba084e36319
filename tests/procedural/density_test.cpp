// Smooth noise: bounded and without steps; grids: as many whole numbers as cells.

#include "procedural/density.h"

#include "core/random.h"
#include "scene_reading.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

TEST(Density, noise_is_bounded_smooth_and_fills_its_range) {
    RandomStream random(7, Purpose::test, 0, 0);
    const auto coordinate = [&] { return 40 * random.next() - 20; };
    double low = 1;
    double high = -1;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d p(coordinate(), coordinate(), coordinate());
        const double value = smooth_noise(p, 9);
        low = std::min(low, value);
        high = std::max(high, value);
        const Vec3d beside = p + Vec3d(1e-4, -1e-4, 1e-4);
        ASSERT_NEAR(smooth_noise(beside, 9), value, 2e-3) << p;
    }
    EXPECT_GE(low, -1);
    EXPECT_LT(high, 1);
    EXPECT_LT(low, -0.6);
    EXPECT_GT(high, 0.6);
}

TEST(Density, noise_of_another_seed_is_another) {
    const Vec3d p(0.3, -4.2, 7.9);
    EXPECT_NE(smooth_noise(p, 1), smooth_noise(p, 2));
}

TEST(Density, a_grid_holds_hundredths_at_the_centres_of_its_cells) {
    const DensityBox box = {{0, -1, 2.5}, {4, 1, 4.5}, {4, 2, 1}};
    const std::string text =
        density_text(box, [](const Vec3d& p) { return p.x / 4 + (p.y > 0 ? 1 : 0); });
    const std::vector<std::string> words = pbrt_words(text);
    EXPECT_EQ(pbrt_numbers(words, 0, "float density"),
              (std::vector<float>{13, 38, 63, 88, 100, 100, 100, 100}));
    EXPECT_EQ(pbrt_numbers(words, 0, "point3 p0"), (std::vector<float>{0, -1, 2.5F}));
    EXPECT_EQ(pbrt_numbers(words, 0, "point3 p1"), (std::vector<float>{4, 1, 4.5F}));
}

}  // namespace
}  // namespace sunfleck::engine
