// Nearest hits against brute force in double; empty, broken and huge input; numbering.
#include "geometry/geometry.h"

#include "geometry/triangle.h"
#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using test::Dice;
using test::distance;
using test::of_one;

constexpr double kFar = 1e300;

struct Truth {
    double t = kFar;
    std::uint32_t primitive = kNone;
    double edge = 0;  // the least barycentric weight: near zero, floats may decide otherwise
    bool is_doubtful = false;  // some triangle's edge, or its plane seen edge on, is near the ray
};

Truth brute_force(const TriangleMesh& mesh, const Ray& ray) {
    Truth truth;
    const Vec3d o(ray.origin);
    const Vec3d d(ray.direction);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& c = mesh.triangles[i];
        const Vec3d p0(mesh.positions[c[0]]);
        const Vec3d e1 = Vec3d(mesh.positions[c[1]]) - p0;
        const Vec3d e2 = Vec3d(mesh.positions[c[2]]) - p0;
        const double determinant = e1.dot(d.cross(e2));
        const double u = (o - p0).dot(d.cross(e2)) / determinant;
        const double v = d.dot((o - p0).cross(e1)) / determinant;
        const double t = e2.dot((o - p0).cross(e1)) / determinant;
        const double edge = std::min({u, v, 1 - u - v});
        const double blur =
            4e-7 * (o - p0).length() * std::max(e1.length(), e2.length()) / std::abs(determinant);
        if (!(t > 0) || !(edge > -blur)) continue;
        truth.is_doubtful = truth.is_doubtful || edge < blur;
        if (edge >= 0 && t < truth.t) truth.t = t, truth.primitive = i;
    }
    return truth;
}

TEST(Geometry, agrees_with_brute_force_but_at_edges) {
    TriangleMesh mesh = test::bumpy_ball(12, 0.1, false);
    Dice dice(20);
    for (std::uint32_t i = 0; i < 60; ++i) {  // and a cloud of triangles
        const Vec3d center = dice.in_box(1.5);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int k = 0; k < 3; ++k) mesh.positions.emplace_back((center + dice.in_box(0.4)));
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    mesh.uvs.clear();
    const Geometry geometry = of_one(mesh);
    int hits = 0;
    int doubtful = 0;
    for (int i = 0; i < 100000; ++i) {
        const Ray ray = test::ray_between(dice.direction() * 3, dice.in_box(1.2));
        const Truth truth = brute_force(mesh, ray);
        if (truth.is_doubtful && ++doubtful > 0) continue;
        const auto hit = geometry.intersect(ray);
        ASSERT_EQ(hit.has_value(), truth.primitive != kNone) << i;
        if (!hit) continue;
        ++hits;
        ASSERT_EQ(hit->primitive, truth.primitive) << i;
        EXPECT_NEAR(hit->distance, truth.t, 3e-7 * truth.t);
        const Vec3d place = Vec3d(ray.origin) + Vec3d(ray.direction) * truth.t;
        EXPECT_LT(distance(Vec3d(hit->position), place), 2e-7);
    }
    EXPECT_GT(hits, 60000);
    EXPECT_LT(doubtful, 20);
}

TEST(Geometry, nothing_is_hit_in_an_empty_scene) {
    const Geometry geometry{GeometryInput{}};
    EXPECT_FALSE(geometry.intersect({{0, 0, 0}, {0, 0, 1}}));
    EXPECT_FALSE(geometry.intersect_precise(Vec3d(0), {0, 0, 1}));
    EXPECT_FALSE(geometry.occluded({{0, 0, 0}, {0, 0, 1}}));
    EXPECT_TRUE(geometry.bounds().is_empty());
    EXPECT_EQ(geometry.bounds().radius(), 0);
    EXPECT_EQ(geometry.triangle_count(), 0U);
    EXPECT_FALSE(of_one(TriangleMesh{}).intersect({{0, 0, 0}, {0, 0, 1}}));
}

TEST(Geometry, both_ends_of_a_ray_are_open) {
    const Geometry flat = of_one(test::one_triangle({-1, -1, 2}, {1, -1, 2}, {0, 1, 2}));
    const Geometry disk = of_one(Disk{2});
    for (const Geometry* g : {&flat, &disk}) {
        EXPECT_TRUE(g->occluded({{0, 0, 0}, {0, 0, 1}, 2.000001F}));
        EXPECT_TRUE(g->intersect({{0, 0, 0}, {0, 0, 1}, 2.000001F}));
        EXPECT_FALSE(g->occluded({{0, 0, 0}, {0, 0, 1}, 1.999999F}));
        EXPECT_FALSE(g->intersect({{0, 0, 0}, {0, 0, 1}, 1.999999F}));
        EXPECT_FALSE(g->occluded({{0, 0, 2}, {0, 0, 1}}));
        EXPECT_FALSE(g->intersect({{0, 0, 2}, {0, 0, 1}}));
        EXPECT_FALSE(g->occluded({{0, 0, 0}, {0, 0, 1}, 0}));
    }
}

TEST(Geometry, broken_input_gives_no_hits_and_never_nan) {
    const float nan = std::nanf("");
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {2, 0, 1}, {nan, 0, 1}, {0, 0, kInfinity}};
    mesh.triangles = {{0, 0, 0}, {0, 1, 1}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}, {0, 1, 77}, {0, 1, 2}};
    mesh.normals.assign(6, Vec3(0));
    mesh.uvs.assign(6, Vec2(0.5F, 0.5F));
    const Geometry geometry = of_one(mesh);
    const auto hit = geometry.intersect({{0.25F, 0.25F, 0}, {0, 0, 1}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->primitive, 6U);  // numbers are those of the input
    EXPECT_EQ(hit->shading_normal, hit->normal);
    EXPECT_GT(hit->tangent.length(), 0);
    EXPECT_TRUE(std::isfinite(hit->tangent.length() + hit->error + hit->uv.x));
    EXPECT_EQ(geometry.triangle_count(), 7U);
    EXPECT_EQ(geometry.bounds().max, Vec3d(1, 1, 1));
    EXPECT_FALSE(geometry.intersect({{0.25F, nan, 0}, {0, 0, 1}}));
    EXPECT_FALSE(geometry.intersect({{0, 0, 0}, {0, 0, nan}}));
    EXPECT_FALSE(geometry.intersect({{0, 0, 0}, {0, 0, 0}}));
    EXPECT_FALSE(geometry.occluded({{0, 0, 0}, {0, 0, 1}, nan}));
    EXPECT_FALSE(geometry.intersect({{1e30F, 0, 0}, {-1, 0, 0}}));
    EXPECT_FALSE(geometry.intersect_precise({0, 0, 1e300}, {0, 0, -1}));
    EXPECT_FALSE(of_one(Sphere{1e30, -1e30, 1e30}).intersect({{0, 0, 0}, {0, 0, -1}}));
    EXPECT_TRUE(
        of_one(test::one_triangle({0, 0, 0}, {1e30F, 0, 0}, {0, 1e30F, 0})).bounds().is_empty());
    EXPECT_FALSE(of_one(Sphere{}, test::scaling(0, 1, 1)).intersect({{0, 0, 9}, {0, 0, -1}}));
}

TEST(Geometry, random_slivers_never_give_nan) {
    Dice dice(21);
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const Vec3d a = dice.in_box(1);
        const Vec3d b = dice.in_box(1);
        const Vec3d c = a + (b - a) * dice.number(-1, 2) + dice.in_box(dice.magnitude(-12, -3));
        for (const Vec3d& p : {a, b, c}) mesh.positions.emplace_back((p));
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const Geometry geometry = of_one(mesh);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto& c = mesh.triangles[dice.below(3000)];
        const Vec3d target = (Vec3d(mesh.positions[c[0]]) + Vec3d(mesh.positions[c[1]])) / 2;
        const auto hit = geometry.intersect(test::ray_between(dice.direction() * 2, target));
        if (!hit) continue;
        ++hits;
        ASSERT_TRUE(std::isfinite(hit->position.length() + hit->error + hit->tangent.length()));
        ASSERT_NEAR(hit->normal.length(), 1, 1e-6);
    }
    EXPECT_GT(hits, 5000);
}

TEST(Geometry, numbers_are_those_of_the_input) {
    GeometryInput input;
    const auto plate = [](float z) {
        return test::one_triangle({-9, -9, z}, {9, -9, z}, {0, 9, z});
    };
    input.shapes = {{plate(1), Matrix(), false},  {Disk{2}, Matrix(), false},
                    {plate(3), Matrix(), false},  {Disk{4}, Matrix(), false},
                    {plate(50), Matrix(), false}, {Disk{60}, Matrix(), false}};
    input.in_world = {2, 3, 0, 1};
    input.instances = {{{5, 4}, test::translation({0, 0, -40}), 7},
                       {{5, 4}, test::translation({0, 0, -30}), 7}};
    const Geometry geometry(std::move(input));
    EXPECT_EQ(geometry.triangle_count(), 4U);
    struct Expected {
        float z;
        std::uint32_t shape;
        std::uint32_t instance;
    };
    for (const Expected& e : {Expected{1, 0, kNone}, Expected{2, 1, kNone}, Expected{3, 2, kNone},
                              Expected{4, 3, kNone}, Expected{10, 4, 0}, Expected{20, 4, 1},
                              Expected{20, 5, 0}, Expected{30, 5, 1}}) {
        const auto hit = geometry.intersect({{0, 0, e.z - 0.5F}, {0, 0, 1}});
        ASSERT_TRUE(hit) << e.z;
        EXPECT_EQ(hit->position.z, e.z);
        if (e.z == 20) continue;  // two at one place
        EXPECT_EQ(hit->shape, e.shape);
        EXPECT_EQ(hit->instance, e.instance);
        EXPECT_EQ(hit->primitive, 0U);
    }
}

/// Ground 10 km wide, a ridge 1 mm high at the origin.
GeometryInput ground_and_ridge() {
    GeometryInput input;
    TriangleMesh ground;
    ground.positions = {
        {-10000, -10000, 0}, {10000, -10000, 0}, {10000, 10000, 0}, {-10000, 10000, 0}};
    ground.triangles = {{0, 1, 2}, {0, 2, 3}};
    TriangleMesh ridge;
    ridge.positions = {{-0.001F, -1, 0}, {0, -1, 0.001F}, {0, 1, 0.001F},
                       {-0.001F, 1, 0},  {0.001F, -1, 0}, {0.001F, 1, 0}};
    ridge.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
    input.shapes = {{ground, Matrix(), false}, {ridge, Matrix(), false}};
    input.in_world = {0, 1};
    return input;
}

/// Height of the ridge over the ground.
double height(const Vec3d& p) {
    return std::max(0.0, 0.001 - std::abs(p.x));
}

TEST(Geometry, small_things_on_a_large_ground_are_right_from_near) {
    const Geometry geometry(ground_and_ridge());
    Dice dice(22);
    for (int i = 0; i < 10000; ++i) {
        const Vec3d target(dice.number(-0.002, 0.002), dice.number(-0.5, 0.5), 0.0005);
        Vec3d from = dice.direction();
        from.z = std::abs(from.z) + 0.1;
        const Ray ray = test::ray_between(target + from, target);
        const auto hit = geometry.intersect(ray);
        ASSERT_TRUE(hit);
        const Vec3d p(hit->position);
        EXPECT_NEAR(p.z, height(p), 1e-7);
        const Vec3d on_ray =
            Vec3d(ray.origin) +
            Vec3d(ray.direction) * (p - Vec3d(ray.origin)).dot(Vec3d(ray.direction));
        EXPECT_LT(distance(p, on_ray), 1e-6);
    }
}

TEST(Geometry, small_things_are_right_from_ten_kilometres) {
    const Geometry geometry(ground_and_ridge());
    Dice dice(23);
    int on_ridge = 0;
    int coarse = 0;
    for (int i = 0; i < 10000; ++i) {
        const Vec3d target(dice.number(-0.002, 0.002), dice.number(-0.5, 0.5), 0.0005);
        Vec3d to_sun = dice.direction();
        to_sun.z = std::abs(to_sun.z) + 0.2;
        to_sun.normalize();
        const Vec3d origin = target + to_sun * 10000;
        const auto hit = geometry.intersect_precise(origin, -to_sun);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->distance, 10000, 0.1);
        const Vec3d p(hit->position);
        EXPECT_NEAR(p.z, height(p), 3e-6);
        const Vec3d on_ray = origin - to_sun * (origin - p).dot(to_sun);
        EXPECT_LT(distance(p, on_ray), 3e-6);
        on_ridge += hit->shape == 1 ? 1 : 0;
        const auto plain = geometry.intersect({Vec3(origin), Vec3(-to_sun)});
        coarse += plain && distance(Vec3d(plain->position), p) > 1e-4 ? 1 : 0;
    }
    EXPECT_GT(on_ridge, 2000);
    EXPECT_GT(coarse, 5000);  // what floats alone make of it
}

/// A float ray from there starts some tenth of the ball beside its mark, if not more.
TEST(Geometry, rays_from_afar_meet_what_rays_from_near_meet) {
    const Geometry geometry = of_one(test::bumpy_ball(40, 0.1, true));
    Dice dice(25);
    for (const double away : {1e4, 1e6, 1e9})
        for (int i = 0; i < 2000; ++i) {
            const Vec3d towards = dice.direction();
            const Vec3d aim = dice.direction() * 0.8;
            const auto near_it = geometry.intersect_precise(aim - towards * 4, towards);
            const auto afar = geometry.intersect_precise(aim - towards * away, towards);
            ASSERT_TRUE(near_it && afar);
            EXPECT_LT(distance(Vec3d(near_it->position), Vec3d(afar->position)),
                      away * 0x1p-46 + 1e-5);
            EXPECT_NEAR(afar->distance, away, 4 + away * 0x1p-23);
        }
}

TEST(Geometry, precise_hits_of_near_things_are_the_plain_ones) {
    const Geometry geometry = of_one(test::bumpy_ball(10, 0.1, true));
    Dice dice(24);
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = test::ray_between(dice.direction() * 3, dice.in_box(0.5));
        const auto plain = geometry.intersect(ray);
        const auto precise = geometry.intersect_precise(Vec3d(ray.origin), Vec3d(ray.direction));
        ASSERT_TRUE(plain && precise);
        EXPECT_LT(distance(Vec3d(plain->position), Vec3d(precise->position)), 1e-6);
    }
}

TEST(Geometry, bounds_hold_what_is_there_tightly) {
    const Matrix matrix =
        test::scaling(1, 2, 3) * test::rotation({1, 1, 1}, 0.7) * test::translation({5, 6, 7});
    Dice dice(25);
    Bounds seen;
    for (int i = 0; i < 200000; ++i) seen.extend(Affine(matrix).point(dice.direction()));
    const Bounds claimed = of_one(Sphere{}, matrix).bounds();
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(claimed.min[axis], seen.min[axis]);
        EXPECT_GE(claimed.max[axis], seen.max[axis]);
        EXPECT_NEAR(claimed.min[axis], seen.min[axis], 1e-3);
        EXPECT_NEAR(claimed.max[axis], seen.max[axis], 1e-3);
    }
    EXPECT_EQ(of_one(test::one_triangle({1, 2, 3}, {-1, 5, 3}, {0, 0, 9})).bounds().max,
              Vec3d(1, 5, 9));
}

}  // namespace
}  // namespace sunfleck::engine
