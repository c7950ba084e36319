// Affine maps: inverse, and normals that stay perpendicular and on their side.
#include "geometry/affine.h"

#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using test::Dice;
using test::distance;

Matrix random_matrix(Dice& dice, bool mirror) {
    const double x = dice.magnitude(-1, 1) * (mirror ? -1 : 1);
    return test::scaling(x, dice.magnitude(-1, 1), dice.magnitude(-1, 1)) *
           test::rotation(dice.direction(), dice.number(0, 6)) * test::translation(dice.in_box(10));
}

TEST(Affine, says_what_the_matrix_says) {
    Dice dice(3);
    const Matrix matrix = random_matrix(dice, false);
    const Vec3d p = dice.in_box(5);
    Vec3d expected;
    matrix.multVecMatrix(p, expected);
    EXPECT_LT(distance(Affine(matrix).point(p), expected), 1e-12);
    matrix.multDirMatrix(p, expected);
    EXPECT_LT(distance(Affine(matrix).vector(p), expected), 1e-12);
}

TEST(Affine, the_inverse_brings_points_back) {
    Dice dice(4);
    for (int i = 0; i < 1000; ++i) {
        const Placement placement(random_matrix(dice, i % 2 == 1));
        const Vec3d p = dice.in_box(5);
        EXPECT_LT(distance(placement.to_object.point(placement.to_world.point(p)), p), 1e-10);
    }
}

TEST(Affine, normals_stay_perpendicular_and_on_the_same_side) {
    Dice dice(5);
    for (int i = 0; i < 1000; ++i) {
        const Placement placement(random_matrix(dice, i % 2 == 1));
        EXPECT_EQ(placement.mirrors, i % 2 == 1);
        const Vec3d normal = dice.direction();
        const Vec3d along = normal.cross(dice.direction());
        const Vec3d image = placement.normal(normal);
        EXPECT_NEAR(image.dot(placement.to_world.vector(along)), 0, 1e-9);
        EXPECT_GT(image.dot(placement.to_world.vector(normal)), 0);
    }
}

TEST(Affine, flat_and_broken_matrices_have_no_inverse) {
    EXPECT_FALSE(Placement(test::scaling(1, 1, 0)).is_invertible);
    EXPECT_FALSE(Placement(test::scaling(1, 1, std::nan(""))).is_invertible);
    EXPECT_FALSE(Placement(test::translation({1, HUGE_VAL, 0})).is_invertible);
    EXPECT_FALSE(Placement(Matrix(1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 0, 0, 0, 1)).is_invertible);
    EXPECT_TRUE(Placement(test::scaling(1, 1e-6, 1e6)).is_invertible);
}

}  // namespace
}  // namespace sunfleck::engine
