// Instances: the same hits as the same shapes placed one by one.
#include "geometry/built.h"

#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using test::Dice;
using test::distance;

std::vector<PlacedShape> object() {
    const Matrix small = test::scaling(0.5, -0.4, 0.3) * test::translation({1.5, 0, 0});
    return {{test::bumpy_ball(8, 0.1, true), Matrix(), false},
            {Sphere{0.4, -0.3, 0.4, 5}, small * test::translation({0, 1, 0}), true},
            {test::bumpy_ball(6, 0.1, false), small, false},
            {Disk{0, 2, 1.2, 4}, test::rotation({1, 2, 0}, 1), false}};
}

std::vector<Matrix> placements(Dice& dice) {
    std::vector<Matrix> all;
    for (int i = 0; i < 12; ++i) {
        const double mirror = i % 2 == 0 ? 1 : -1;
        Matrix m = test::scaling(mirror * dice.number(0.5, 2), dice.number(0.5, 2), 1) *
                   test::rotation(dice.direction(), dice.number(0, 6)) *
                   test::translation(dice.in_box(20));
        for (int k = 0; k < 4; ++k)
            for (int j = 0; j < 3; ++j) m[k][j] = static_cast<float>(m[k][j]);
        all.push_back(m);
    }
    return all;
}

/// Shape s under placement i is shape 4 i + s of the flat scene.
struct BothWays {
    Geometry instanced;
    Geometry flat;
};

BothWays build_both(const std::vector<Matrix>& matrices) {
    GeometryInput instanced;
    GeometryInput flat;
    instanced.shapes = object();
    for (const Matrix& matrix : matrices) {
        instanced.instances.push_back({{0, 1, 2, 3}, matrix, 0});
        for (const PlacedShape& shape : object()) {
            flat.in_world.push_back(static_cast<std::uint32_t>(flat.shapes.size()));
            flat.shapes.push_back({shape.shape, shape.to_world * matrix, shape.flip});
        }
    }
    return {Geometry(std::move(instanced)), Geometry(std::move(flat))};
}

TEST(Built, instances_are_hit_like_shapes_placed_one_by_one) {
    Dice dice(40);
    const std::vector<Matrix> matrices = placements(dice);
    const BothWays scenes = build_both(matrices);
    EXPECT_EQ(scenes.instanced.triangle_count(), scenes.flat.triangle_count());
    std::array<int, 4> hits{};
    int different = 0;
    for (int i = 0; i < 40000; ++i) {
        const Vec3d target = Affine(matrices[dice.below(12)]).point(dice.in_box(1.5));
        const Ray ray = test::ray_between(target + dice.direction() * 10, target);
        const auto a = scenes.instanced.intersect(ray);
        const auto b = scenes.flat.intersect(ray);
        EXPECT_EQ(scenes.instanced.occluded(ray), a.has_value());
        if (a.has_value() != b.has_value() || (a && 4 * a->instance + a->shape != b->shape) ||
            (a && a->primitive != b->primitive)) {
            ++different;  // at an edge
            continue;
        }
        if (!a) continue;
        ++hits.at(a->shape);
        const double slack = 1e-5 / std::abs(a->normal.dot(ray.direction));  // at grazing angles
        EXPECT_LT(distance(Vec3d(a->position), Vec3d(b->position)), slack);
        EXPECT_NEAR(a->distance, b->distance, slack);
        EXPECT_GT(a->normal.dot(b->normal), 0.99999F);
        EXPECT_GT(a->shading_normal.dot(b->shading_normal), 0.99999F);
        EXPECT_LT((a->tangent - b->tangent).length(), 1e-3F * b->tangent.length());
        EXPECT_LT((a->uv - b->uv).length(), 1e-4F);
    }
    for (const int count : hits) EXPECT_GT(count, 100);
    EXPECT_LT(different, 40);
}

TEST(Built, bounds_of_instances_hold_the_flat_ones) {
    Dice dice(41);
    const BothWays scenes = build_both(placements(dice));
    const Bounds& outer = scenes.instanced.bounds();
    const Bounds& inner = scenes.flat.bounds();
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(outer.min[axis], inner.min[axis] + 1e-4);
        EXPECT_GE(outer.max[axis], inner.max[axis] - 1e-4);
    }
    EXPECT_LT(outer.radius(), 2 * inner.radius());
}

TEST(Built, a_thousand_instances_share_one_tree) {
    GeometryInput input;
    input.shapes.push_back({test::bumpy_ball(100, 0.01, false), Matrix(), false});
    for (int i = 0; i < 1000; ++i)
        input.instances.push_back({{0}, test::translation({3.0 * i, 0, 0}), 0});
    input.instances.push_back({{0}, test::scaling(1, 0, 1), 0});  // flat: left out
    const Geometry geometry(std::move(input));  // 20 million triangles: would take gigabytes
    EXPECT_EQ(geometry.triangle_count(), 1001U * 20000U);
    for (const std::uint32_t i : {0U, 17U, 999U}) {
        const auto hit = geometry.intersect({{3.0F * static_cast<float>(i), 0, 5}, {0, 0, -1}});
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->instance, i);
        EXPECT_NEAR(hit->position.z, 1, 0.02);
    }
}

}  // namespace
}  // namespace sunfleck::engine
