// What holds for every shape: hits lie on the ray, rays leave, normals, tangents, bounds, areas.
#include "geometry/measure.h"
#include "laws/shape_examples.h"
#include "math/statistics.h"

#include <gtest/gtest.h>

#include <set>

namespace sunfleck::engine {
namespace {

using test::Dice;
using test::distance;
using test::ShapeExample;

constexpr double kReach = 2.2;  // of a ball around each example's center that holds it

class ShapeLaws : public testing::TestWithParam<ShapeExample> {
protected:
    Geometry build(bool flip = false) const {
        return test::of_one(GetParam().shape, GetParam().to_world, flip);
    }
    /// Then v says where across the tube a ray sees it, and depends on the ray.
    static bool is_tube() {
        const auto* curves = std::get_if<Curves>(&GetParam().shape);
        return curves != nullptr && curves->kind == CurveKind::cylinder;
    }
    Ray random_ray() {
        const Vec3d from = center_ + dice_.direction() * kReach;
        return test::ray_between(from, center_ + dice_.in_box(1));
    }

    Dice dice_{60};
    Vec3d center_ = Affine(GetParam().to_world).origin;
    Geometry geometry_ = build();
};

TEST_P(ShapeLaws, hits_lie_on_the_ray_and_within_the_bounds) {
    int hits = 0;
    for (int i = 0; i < 5000; ++i) {
        const Ray ray = random_ray();
        const auto hit = geometry_.intersect(ray);
        EXPECT_EQ(geometry_.occluded(ray), hit.has_value());
        if (!hit) continue;
        ++hits;
        const Vec3d place = Vec3d(ray.origin) + Vec3d(ray.direction) * double{hit->distance};
        EXPECT_LT(distance(place, Vec3d(hit->position)), 2e-6);
        EXPECT_NEAR(hit->normal.length(), 1, 1e-6);
        EXPECT_NEAR(hit->shading_normal.length(), 1, 1e-6);
        EXPECT_GT(hit->normal.dot(hit->shading_normal), 0);
        EXPECT_GT(hit->error, 0);
        EXPECT_LT(hit->error, 2e-5);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(hit->position[axis], geometry_.bounds().min[axis] - 1e-6);
            EXPECT_LE(hit->position[axis], geometry_.bounds().max[axis] + 1e-6);
        }
    }
    EXPECT_GT(hits, 500);
}

/// The next hit of the same primitive, if there is one, is seen from the side that the ray is on.
TEST_P(ShapeLaws, rays_that_leave_do_not_meet_the_place_they_left) {
    for (int i = 0; i < 5000; ++i) {
        const auto hit = geometry_.intersect(random_ray());
        if (!hit) continue;
        const Vec3 out = dice_.direction_float();
        const auto next = geometry_.intersect(test::leaving(*hit, out));
        if (!next || next->primitive != hit->primitive) continue;
        EXPECT_LT(hit->normal.dot(out) * next->normal.dot(out), 0);
    }
}

TEST_P(ShapeLaws, flip_turns_the_normals_and_nothing_else) {
    const Geometry flipped = build(true);
    for (int i = 0; i < 1000; ++i) {
        const Ray ray = random_ray();
        const auto a = geometry_.intersect(ray);
        const auto b = flipped.intersect(ray);
        ASSERT_EQ(a.has_value(), b.has_value());
        if (!a) continue;
        EXPECT_EQ(a->normal, -b->normal);
        EXPECT_EQ(a->shading_normal, -b->shading_normal);
        EXPECT_EQ(a->position, b->position);
        EXPECT_EQ(a->tangent, b->tangent);
        EXPECT_EQ(a->uv, b->uv);
    }
}

/// Seen in the object's frame, the normal is on the same side under every matrix.
TEST_P(ShapeLaws, matrices_move_normals_as_they_move_the_surface) {
    const Geometry plain = test::of_one(GetParam().shape);
    const Placement placement(GetParam().to_world);
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const Ray ray = random_ray();
        const auto placed = geometry_.intersect(ray);
        const auto local = plain.intersect(
            test::ray_between(placement.to_object.point(Vec3d(ray.origin)),
                              placement.to_object.point(Vec3d(ray.origin + ray.direction))));
        if (!placed || !local || placed->primitive != local->primitive) continue;
        ++hits;
        const Vec3d expected = placement.normal(Vec3d(local->normal)).normalized();
        EXPECT_GT(expected.dot(Vec3d(placed->normal)), 0.9999);
    }
    EXPECT_GT(hits, 300);
}

/// A small step along the surface changes u by the part of the step along dp/du.
TEST_P(ShapeLaws, tangents_are_the_derivatives_by_u) {
    int compared = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto hit = geometry_.intersect(random_ray());
        if (!hit) continue;
        const Vec3d tangent(hit->tangent);
        EXPECT_LT(std::abs(tangent.dot(Vec3d(hit->normal))), 1e-4 * tangent.length());
        const double step = 1e-3 / tangent.length();
        const Vec3d over = Vec3d(hit->position) + tangent * step + Vec3d(hit->normal) * 0.01;
        const auto next = geometry_.intersect({Vec3(over), -hit->normal, 0.02F});
        if (!next || next->primitive != hit->primitive) continue;
        const double change = next->uv.x - hit->uv.x;
        if (std::abs(change) > 0.5) continue;  // across the seam
        if (tangent.length() < 0.5) continue;  // near a pole: u turns faster than the step
        ++compared;
        EXPECT_NEAR(change / step, 1, 0.05);
        const double v = is_tube() ? next->uv.y : hit->uv.y;
        EXPECT_NEAR(next->uv.y, v, 0.1 * step + 2e-6);
    }
    EXPECT_GT(compared, 200);
}

/// Crofton: uniform random lines through a ball of radius R (chords between uniform points of its
/// sphere) cross a surface of area A on average A / (2 pi R^2) times.
/// Fixed seed; 5 standard errors (6e-7, two-sided); errors of the area from 4% on are seen.
TEST_P(ShapeLaws, random_lines_measure_the_area) {
    if (std::holds_alternative<Curves>(GetParam().shape)) GTEST_SKIP() << "curves have no area";
    RunningMean crossings;
    for (int i = 0; i < 300000; ++i) {
        Ray ray = test::ray_between(center_ + dice_.direction() * kReach,
                                    center_ + dice_.direction() * kReach);
        int count = 0;
        for (auto hit = geometry_.intersect(ray); hit; hit = geometry_.intersect(ray)) {
            ++count;
            ray = test::leaving(*hit, ray.direction);
        }
        crossings.add(count);
    }
    const double area = surface_area({GetParam().shape, GetParam().to_world, false});
    const double expected = area / (2 * kPiDouble * kReach * kReach);
    EXPECT_NEAR(crossings.mean(), expected, 5 * crossings.standard_error());
    EXPECT_LT(crossings.standard_error(), 0.008 * expected);
}

INSTANTIATE_TEST_SUITE_P(Examples, ShapeLaws, testing::ValuesIn(test::shape_examples()),
                         [](const auto& one) { return one.param.name; });

TEST(ShapeExamples, cover_each_alternative) {
    std::set<std::size_t> seen;
    for (const ShapeExample& example : test::shape_examples()) seen.insert(example.shape.index());
    EXPECT_EQ(seen.size(), std::variant_size_v<Shape>);
}

}  // namespace
}  // namespace sunfleck::engine
