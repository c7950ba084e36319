// Transforms of column vectors.
#include <gtest/gtest.h>
#include <sunfleck/error.h>
#include <sunfleck/transform.h>

#include <cfenv>

namespace sunfleck {
namespace {

Vector mapped(const Transform& transform, const Vector& point) {
    Vector result{};
    for (unsigned row = 0; row < 3; ++row) {
        result.at(row) = transform.rows().at(row)[3];
        for (unsigned column = 0; column < 3; ++column)
            result.at(row) += transform.rows().at(row).at(column) * point.at(column);
    }
    return result;
}

void expect_near(const Vector& a, const Vector& b) {
    for (unsigned i = 0; i < 3; ++i) EXPECT_NEAR(a.at(i), b.at(i), 1e-12);
}

TEST(Transform, products_map_by_the_right_factor_first) {
    const Transform product = Transform::translate({1, 2, 3}) * Transform::scale({2, 2, 2});
    expect_near(mapped(product, {1, 1, 1}), {3, 4, 5});
    expect_near(mapped(Transform::rotate(90, {0, 0, 5}), {1, 0, 0}), {0, 1, 0});
}

TEST(Transform, look_at_places_a_camera) {
    const Transform camera = Transform::look_at({1, 2, 3}, {1, 2, 8}, {0, 1, 0});
    expect_near(mapped(camera, {0, 0, 0}), {1, 2, 3});
    expect_near(mapped(camera, {0, 0, 1}), {1, 2, 4});
    expect_near(mapped(camera, {0, 1, 0}), {1, 3, 3});
}

TEST(Transform, does_not_depend_on_the_modes_of_the_caller) {
    const auto made = [] {
        return Transform::rotate(33.3, {1, 2, 3}) * Transform::scale({1.1, 0.9, 0.7}) *
               Transform::look_at({1, 2, 3}, {0.1, 0.2, 0.3}, {0, 1, 0});
    };
    const Transform expected = made();
    std::fesetround(FE_UPWARD);
    const Transform rounded = made();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(rounded.rows(), expected.rows());
}

TEST(Transform, refuses_what_has_no_inverse) {
    EXPECT_THROW(Transform::scale({1, 0, 1}), Error);
    EXPECT_THROW(Transform::rotate(30, {0, 0, 0}), Error);
    EXPECT_THROW(Transform::look_at({0, 0, 0}, {0, 0, 1}, {0, 0, 1}), Error);
    EXPECT_THROW(Transform(Transform::Rows{}), Error);
}

}  // namespace
}  // namespace sunfleck
