// Areas against closed forms.
#include "geometry/measure.h"

#include "geometry/quadrature.h"
#include "geometry/sweep.h"
#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using test::scaling;

TEST(Measure, arc_cosine_is_good_to_the_last_bits) {
    for (int i = -1000; i <= 1000; ++i)
        EXPECT_NEAR(arc_cosine(i / 1000.0), std::acos(i / 1000.0), 1e-14) << i;
    EXPECT_NEAR(arc_cosine(1 - 1e-12), std::acos(1 - 1e-12), 1e-12);
    EXPECT_NEAR(arc_cosine(1e-12 - 1), std::acos(1e-12 - 1), 1e-9);
}

TEST(Measure, a_mesh_is_the_sum_of_its_triangles) {
    TriangleMesh square;
    square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 1}, {0, 1, 9}};
    EXPECT_DOUBLE_EQ(surface_area({square, scaling(3, -2, 5), true}), 6);
}

TEST(Measure, spheres_under_similarities) {
    const Sphere part{2, -1, 1.5, 1};
    EXPECT_NEAR(surface_area({Sphere{}, Matrix(), false}), 4 * kPiDouble, 1e-12);
    const Matrix turned =
        scaling(3, -3, 3) * test::rotation({1, 2, 3}, 1) * test::translation({9, 8, 7});
    EXPECT_NEAR(surface_area({part, turned, false}), 9 * 2 * 2.5, 1e-9);
    EXPECT_NEAR(surface_area({Sphere{2, -9, 9, 99}, Matrix(), false}), 16 * kPiDouble, 1e-9);
}

/// Prolate spheroid with half-axes a, a, c: 2 pi a^2 (1 + c / (a e) asin e), e^2 = 1 - a^2/c^2.
TEST(Measure, stretched_spheres) {
    for (const double c : {1.001, 2.0, 20.0, 200.0}) {
        const double e = std::sqrt(1 - 1 / (c * c));
        const double expected = 2 * kPiDouble * (1 + c / e * std::asin(e));
        EXPECT_NEAR(surface_area({Sphere{}, scaling(1, 1, c), false}) / expected, 1, 1e-6) << c;
        const Matrix lying = scaling(c, 1, 1) * test::rotation({1, 1, 0}, 1);
        EXPECT_NEAR(surface_area({Sphere{}, lying, false}) / expected, 1, 1e-6) << c;
    }
}

TEST(Measure, half_a_stretched_sphere_is_half) {
    const Matrix any = scaling(1, 2, 3);
    const double whole = surface_area({Sphere{}, any, false});
    EXPECT_NEAR(surface_area({Sphere{1, 0, 1, kFullCircle}, any, false}) / whole, 0.5, 1e-6);
    EXPECT_NEAR(surface_area({Sphere{1, -1, 1, kPiDouble / 2}, any, false}) / whole, 0.25, 1e-6);
}

TEST(Measure, disks_under_any_map) {
    EXPECT_NEAR(surface_area({Disk{}, scaling(2, 3, 7), false}), 6 * kPiDouble, 1e-12);
    const Matrix sheared(1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    EXPECT_NEAR(surface_area({Disk{4, 2, 1, 1}, sheared, false}), 1.5, 1e-12);
}

}  // namespace
}  // namespace sunfleck::engine
