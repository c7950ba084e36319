// Bilinear patches: against fine meshes of triangles and closed forms, their sides, coordinates,
// areas; rays that leave; instances.
#include "geometry/bilinear_mesh.h"
#include "geometry/measure.h"
#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using test::Dice;
using test::distance;
using test::of_one;

BilinearMesh wild_patch(Dice& dice, double size, const Vec3d& center) {
    BilinearMesh mesh;
    for (const Vec2d& c : {Vec2d(-1, -1), Vec2d(1, -1), Vec2d(-1, 1), Vec2d(1, 1)})
        mesh.positions.emplace_back(center + (Vec3d(c.x, c.y, 0) + dice.in_box(0.8)) * size);
    mesh.patches = {{0, 1, 2, 3}};
    return mesh;
}

/// 2 n^2 triangles with the patch's points as vertices.
TriangleMesh fine_mesh(const BilinearMesh& patches, std::uint32_t n) {
    TriangleMesh mesh;
    for (std::uint32_t patch = 0; patch < patches.count(); ++patch) {
        const Bilinear surface = patches.element(patch).surface;
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (std::uint32_t j = 0; j <= n; ++j)
            for (std::uint32_t i = 0; i <= n; ++i)
                mesh.positions.emplace_back(surface.point({double(i) / n, double(j) / n}));
        for (std::uint32_t j = 0; j < n; ++j)
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t a = first + j * (n + 1) + i;
                mesh.triangles.push_back({a, a + 1, a + n + 2});
                mesh.triangles.push_back({a, a + n + 2, a + n + 1});
            }
    }
    return mesh;
}

/// Sees a normal of the wrong side, a patch turned about, and parts that are missing.
TEST(Bilinear, is_the_limit_of_fine_meshes) {
    Dice dice(70);
    int hits = 0;
    int unlike = 0;
    for (int k = 0; k < 20; ++k) {
        const BilinearMesh patch = wild_patch(dice, 1, Vec3d(0));
        const Geometry exact = of_one(patch);
        const Geometry fine = of_one(fine_mesh(patch, 64));
        for (int i = 0; i < 500; ++i) {
            const Ray ray = test::ray_between(dice.direction() * 4, dice.in_box(1));
            const auto a = exact.intersect(ray);
            const auto b = fine.intersect(ray);
            EXPECT_EQ(exact.occluded(ray), a.has_value());
            hits += a ? 1 : 0;
            const bool alike = a.has_value() == b.has_value() &&
                               (!a || distance(Vec3d(a->position), Vec3d(b->position)) < 0.01);
            unlike += alike ? 0 : 1;  // at the rim, and where rays graze
            if (!a || !alike) continue;
            EXPECT_GT(a->normal.dot(b->normal), 0.99);
        }
    }
    EXPECT_GT(hits, 3000);
    EXPECT_LT(unlike, 40);
}

/// z = x y over the unit square: u = x, v = y.
TEST(Bilinear, hyperbolic_paraboloid) {
    BilinearMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}};
    mesh.patches = {{0, 1, 2, 3}};
    const Geometry geometry = of_one(mesh);
    Dice dice(71);
    for (int i = 0; i < 2000; ++i) {
        const double x = dice.number(-0.2, 1.2);
        const double y = dice.number(-0.2, 1.2);
        const auto hit = geometry.intersect({Vec3(Vec3d(x, y, 3)), {0, 0, -1}});
        const Vec3d p(float(x), float(y), double(float(x)) * float(y));
        ASSERT_EQ(hit.has_value(), p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1);
        if (!hit) continue;
        EXPECT_LT(distance(Vec3d(hit->position), p), 1e-7);
        EXPECT_NEAR(hit->uv.x, p.x, 1e-7);
        EXPECT_NEAR(hit->uv.y, p.y, 1e-7);
        EXPECT_LT(distance(Vec3d(hit->tangent), {1, 0, p.y}), 1e-6);
        EXPECT_LT(distance(Vec3d(hit->normal), Vec3d(-p.y, -p.x, 1).normalized()), 1e-6);
    }
    // Integral of sqrt(1 + x^2 + y^2) over the unit square.
    EXPECT_NEAR(surface_area({mesh, Matrix(), false}), 1.2807892768, 1e-6);
}

TEST(Bilinear, given_normals_decide_the_side_and_flip_negates_them) {
    for (const bool flip : {false, true})
        for (const double mirror : {1.0, -1.0})
            for (const float side : {1.0F, -1.0F, 0.0F}) {
                BilinearMesh mesh;
                mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}};
                mesh.patches = {{0, 1, 2, 3}};
                if (side != 0) mesh.normals.assign(4, Vec3(0.6F, 0, 0.8F * side));
                const auto hit = of_one(mesh, test::scaling(mirror, 1, 1), flip)
                                     .intersect({{0.3F, 0, 5}, {0, 0, -1}});
                ASSERT_TRUE(hit);
                const float outside = (side < 0 ? -1.0F : 1.0F) * (flip ? -1.0F : 1.0F);
                EXPECT_EQ(hit->normal, Vec3(0, 0, outside));
                EXPECT_NEAR(hit->shading_normal.z, side == 0 ? outside : 0.8F * outside, 1e-6);
            }
}

TEST(Bilinear, given_coordinates_turn_the_tangent) {
    BilinearMesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}};
    mesh.patches = {{0, 1, 2, 3}};
    mesh.uvs = {{0, 5}, {0, 7}, {3, 5}, {3, 7}};  // s = 3 y, t = 5 + x
    const auto hit = of_one(mesh).intersect({{0.5F, 0.25F, 5}, {0, 0, -1}});
    ASSERT_TRUE(hit);
    EXPECT_LT(distance(Vec3d(hit->tangent), {0, 1.0 / 3, 0}), 1e-6);
    EXPECT_LT(distance({hit->uv.x, hit->uv.y, 0}, {0.75, 5.5, 0}), 1e-6);
}

/// In the world or in an instance, near and far, small and large; also flat ones and such with
/// two corners in one place. The surface met next, if any, is met from its other side.
TEST(Bilinear, does_not_meet_itself) {
    Dice dice(72);
    int hits = 0;
    for (int i = 0; i < 400; ++i) {
        const double size = dice.magnitude(-3, 3);
        const Vec3d center = dice.in_box(1) * dice.magnitude(-3, 3);
        BilinearMesh patch = wild_patch(dice, size, center);
        if (i % 4 == 1) patch.positions[3] = patch.positions[2];
        if (i % 4 == 2)
            patch.positions[3] = patch.positions[1] + patch.positions[2] - patch.positions[0];
        GeometryInput input;
        input.shapes.push_back({patch, Matrix(), false});
        Affine map;
        if (i % 2 == 0) {
            input.in_world = {0};
        } else {
            const Matrix matrix = test::scaling(2, dice.magnitude(-1, 1), -1) *
                                  test::rotation(dice.direction(), dice.number(0, 6)) *
                                  test::translation(dice.in_box(1));
            input.instances.push_back({{0}, matrix, 0});
            map = Affine(matrix);
        }
        const Geometry geometry(std::move(input));
        const Bilinear surface = patch.element(0).surface.image(map);
        for (int j = 0; j < 60; ++j) {
            const Vec3d target = surface.point({dice.number(0, 1), dice.number(0, 1)});
            const Vec3d from = target + dice.direction() * 3 * geometry.bounds().radius();
            const auto hit = geometry.intersect(test::ray_between(from, target));
            if (!hit) continue;
            ++hits;
            const Vec3 out = dice.direction_float();
            const auto next = geometry.intersect(test::leaving(*hit, out));
            EXPECT_TRUE(!next || hit->normal.dot(out) * next->normal.dot(out) < 0);
        }
    }
    EXPECT_GT(hits, 15000);
}

/// Rays at the sides that patches share: none slips through.
TEST(Bilinear, neighbours_leave_no_gap) {
    BilinearMesh mesh;
    Dice dice(73);
    for (std::uint32_t j = 0; j < 5; ++j)
        for (std::uint32_t i = 0; i < 5; ++i)
            mesh.positions.emplace_back(float(i), float(j), float(dice.number(-0.4, 0.4)));
    for (std::uint32_t j = 0; j < 4; ++j)
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t a = 5 * j + i;
            mesh.patches.push_back({a, a + 1, a + 5, a + 6});
        }
    const Geometry geometry = of_one(mesh, test::rotation({1, 2, 3}, 1));
    const Affine map(test::rotation({1, 2, 3}, 1));
    for (int k = 0; k < 20000; ++k) {
        const Bilinear patch = mesh.element(dice.below(16)).surface.image(map);
        const double along = dice.number(0, 1);
        const Vec3d target = patch.point(k % 2 == 0 ? Vec2d(1, along) : Vec2d(along, 1));
        const Vec3d inner = map.point({2, 2, 0});
        const Vec3d aim = target + (inner - target) * 1e-3;  // off the outer rim
        const Vec3d toward = k % 3 == 0 ? aim : target;
        const bool rim = (map.point({4, 4, 0}) - target).length() < 1e-9;
        const Vec3d from = toward + map.vector({dice.number(-1, 1), dice.number(-1, 1), 6});
        if (rim) continue;
        const auto hit = geometry.intersect(test::ray_between(from, toward));
        const Vec3d own = Affine(test::rotation({1, 2, 3}, -1)).point(toward);
        if (own.x > 3.99 || own.y > 3.99) continue;
        EXPECT_TRUE(hit) << k;
    }
}

TEST(Bilinear, instances_are_where_their_flattened_copies_are) {
    Dice dice(74);
    const Matrix inner = test::rotation({1, 1, 0}, 0.4) * test::scaling(1, 2, 1);
    const Matrix outer = test::scaling(1.5, -1, 0.5) * test::translation({1, 2, 3});
    const BilinearMesh patch = wild_patch(dice, 1, Vec3d(0));
    GeometryInput input;
    input.shapes.push_back({patch, inner, true});
    input.instances.push_back({{0}, outer, 0});
    const Geometry instanced(std::move(input));
    const Geometry flat = of_one(patch, inner * outer, true);
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3d to = Affine(outer).point(dice.in_box(1));
        const Ray ray = test::ray_between(to + dice.direction() * 8, to);
        const auto a = instanced.intersect(ray);
        const auto b = flat.intersect(ray);
        ASSERT_EQ(a.has_value(), b.has_value());
        if (!a) continue;
        ++hits;
        EXPECT_LT(distance(Vec3d(a->position), Vec3d(b->position)), 2e-6);
        EXPECT_GT(a->normal.dot(b->normal), 0.99999);
        EXPECT_NEAR(a->uv.x, b->uv.x, 1e-5);
    }
    EXPECT_GT(hits, 500);
}

}  // namespace
}  // namespace sunfleck::engine
