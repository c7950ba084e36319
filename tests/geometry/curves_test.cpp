// Curves: tubes and ribbons against fine meshes and closed forms, flat strips against the distance
// from the axis; normals, coordinates, rays that leave, instances.
#include "geometry/curves.h"

#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using test::Dice;
using test::distance;
using test::of_one;

Curves wild_curve(Dice& dice, CurveKind kind, double width) {
    Curves curves;
    curves.kind = kind;
    CurveSegment segment;
    for (std::size_t i = 0; i < 4; ++i)
        segment.points.at(i) = Vec3(Vec3d(double(i) - 1.5, 0, 0) + dice.in_box(0.45));
    segment.width = {float(width), float(width * dice.number(0.4, 1))};
    const Vec3d up(0, 0, 1);
    segment.normal = {Vec3(up + dice.in_box(0.4)), Vec3(up + dice.in_box(0.4))};
    curves.segments = {segment};
    return curves;
}

/// A straight one along x, from -1 to 1, whose u is (x + 1) / 2.
Curves straight(CurveKind kind, float start, float end) {
    Curves curves;
    curves.kind = kind;
    curves.segments = {
        {{Vec3(-1, 0, 0), Vec3(-1.0F / 3, 0, 0), Vec3(1.0F / 3, 0, 0), Vec3(1, 0, 0)},
         {start, end},
         {Vec3(0, 0, 1), Vec3(0, 0, 1)}}};
    return curves;
}

/// Rings of points around the curve, or pairs at both sides of a ribbon.
TriangleMesh swept_mesh(const Curves& curves, std::uint32_t along, std::uint32_t around) {
    TriangleMesh mesh;
    const CurvePiece piece = curves.element(0);
    const bool tube = curves.kind == CurveKind::cylinder;
    for (std::uint32_t i = 0; i <= along; ++i) {
        const double u = double(i) / along;
        const CurvePoint c = evaluate(piece.curve, u);
        const Vec3d t = c.first.normalized();
        const Vec3d x = tube ? t.cross(Vec3d(0.1, 0.2, 1)).normalized() : piece.across_ribbon(c, u);
        const Vec3d y = t.cross(x);
        for (std::uint32_t j = 0; j <= around; ++j) {
            const double angle = 2 * kPiDouble * j / around;
            const double half = piece.width_at(u) / 2;
            const Vec3d off =
                tube ? x * std::cos(angle) + y * std::sin(angle) : x * (2.0 * j / around - 1);
            mesh.positions.emplace_back(c.position + off * half);
        }
    }
    for (std::uint32_t i = 0; i < along; ++i)
        for (std::uint32_t j = 0; j < around; ++j) {
            const std::uint32_t a = i * (around + 1) + j;
            const std::uint32_t b = a + around + 1;
            mesh.triangles.push_back({a, b, b + 1});
            mesh.triangles.push_back({a, b + 1, a + 1});
        }
    return mesh;
}

/// All hits of a line, entering and leaving.
int count_hits(const Geometry& geometry, Ray ray) {
    int count = 0;
    for (auto hit = geometry.intersect(ray); hit && count < 20; hit = geometry.intersect(ray)) {
        ++count;
        ray = test::leaving(*hit, ray.direction);
    }
    return count;
}

class SweptCurves : public testing::TestWithParam<CurveKind> {};

/// Wide ones, so that bends and both sides matter; all crossings of a line are counted.
TEST_P(SweptCurves, are_the_limits_of_fine_meshes) {
    Dice dice(80);
    int hits = 0;
    int unlike = 0;
    for (int k = 0; k < 20; ++k) {
        const Curves curves = wild_curve(dice, GetParam(), 0.3);
        const Geometry exact = of_one(curves);
        const Geometry fine = of_one(swept_mesh(curves, 128, 64));
        for (int i = 0; i < 500; ++i) {
            const Ray ray = test::ray_between(dice.direction() * 4, dice.in_box(0.8));
            const auto a = exact.intersect(ray);
            const auto b = fine.intersect(ray);
            EXPECT_EQ(exact.occluded(ray), a.has_value());
            const bool alike = a.has_value() == b.has_value() &&
                               count_hits(exact, ray) == count_hits(fine, ray) &&
                               (!a || distance(Vec3d(a->position), Vec3d(b->position)) < 0.02);
            unlike += alike ? 0 : 1;
            if (!a || !alike) continue;
            ++hits;
            EXPECT_GT(std::abs(a->normal.dot(b->normal)), 0.97);
        }
    }
    EXPECT_GT(hits, 800);
    EXPECT_LT(unlike, hits / 40);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SweptCurves,
                         testing::Values(CurveKind::cylinder, CurveKind::ribbon));

/// A cone cut off: normals lean by the slope; open at both ends.
TEST(Curves, straight_tube_is_a_cone) {
    const Geometry geometry = of_one(straight(CurveKind::cylinder, 1, 0.5F));
    const double slope = -0.25 / 2;  // of the radius by x
    for (const float x : {-0.9F, 0.0F, 0.7F}) {
        const auto hit = geometry.intersect({{x, 0, 5}, {0, 0, -1}});
        ASSERT_TRUE(hit);
        const double radius = 0.375 + slope * double{x};
        EXPECT_NEAR(hit->position.z, radius, 1e-6);
        EXPECT_LT(distance(Vec3d(hit->normal), Vec3d(-slope, 0, 1).normalized()), 1e-6);
        EXPECT_NEAR(hit->uv.x, (x + 1) / 2, 1e-6);
        EXPECT_NEAR(hit->uv.y, 0.5, 1e-6);
        EXPECT_LT(distance(Vec3d(hit->tangent), {2, 0, 2 * slope}), 1e-5);
        const auto inside = geometry.intersect({{x, 0, 0}, {0, 0, -1}});
        ASSERT_TRUE(inside);
        EXPECT_LT(inside->normal.z, -0.9F);
    }
    EXPECT_FALSE(geometry.intersect({{-1.01F, 0, 5}, {0, 0, -1}}));
    EXPECT_FALSE(geometry.intersect({{5, 0.1F, 0.1F}, {-1, 0, 0}}));
}

/// It faces each ray: met where the axis passes it within half the width, at the axis' depth.
TEST(Curves, flat_strip_faces_the_ray) {
    const Geometry geometry = of_one(straight(CurveKind::flat, 0.5F, 0.5F));
    Dice dice(81);
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const Ray ray = test::ray_between(dice.direction() * 3, dice.in_box(0.5));
        const Vec3d o(ray.origin);
        const Vec3d d(ray.direction);
        // Nearest points of the line and of the x axis.
        const double t = -(o.y * d.y + o.z * d.z) / (d.y * d.y + d.z * d.z);
        const Vec3d p = o + d * t;
        const double away = std::hypot(p.y, p.z);
        // In the ray's view the strip ends at right angles to the axis: at the axis' x.
        const double x = p.x;
        const auto hit = geometry.intersect(ray);
        if (std::abs(away - 0.25) < 1e-5 || std::abs(std::abs(x) - 1) < 1e-5) continue;
        ASSERT_EQ(hit.has_value(), t > 0 && away < 0.25 && std::abs(x) < 1) << away << ' ' << x;
        EXPECT_EQ(geometry.occluded(ray), hit.has_value());
        if (!hit) continue;
        ++hits;
        EXPECT_NEAR(hit->distance, t, 1e-5);
        EXPECT_NEAR(hit->uv.x, (x + 1) / 2, 1e-5);
        EXPECT_NEAR(std::abs(hit->uv.y - 0.5F), away / 0.5, 1e-5);
        EXPECT_LT(hit->normal.dot(ray.direction), 0);
        EXPECT_NEAR(hit->normal.x, 0, 1e-6);
        EXPECT_FALSE(geometry.intersect(test::leaving(*hit, ray.direction)));
        EXPECT_FALSE(geometry.intersect(test::leaving(*hit, dice.direction_float())));
    }
    EXPECT_GT(hits, 500);
    const auto left = geometry.intersect({{0, 0.1F, 5}, {0, 0, -1}});
    ASSERT_TRUE(left);
    EXPECT_NEAR(left->uv.y, 0.5 - 0.2, 1e-6);  // v grows along direction x dp/du
}

TEST(Curves, ribbon_lies_as_its_normals_say) {
    Curves curves = straight(CurveKind::ribbon, 0.5F, 0.5F);
    curves.segments[0].normal = {Vec3(0, 0, 2), Vec3(0, 1, 0)};
    const Geometry geometry = of_one(curves);
    for (const float x : {-0.999F, -0.5F, 0.0F, 0.8F}) {
        const double angle = kPiDouble / 4 * (double{x} + 1);  // evenly turned
        const Vec3d normal(0, std::sin(angle), std::cos(angle));
        const Vec3d start = Vec3d(double{x}, 0, 0) + normal * 2;
        const auto hit = geometry.intersect(test::ray_between(start, {double{x}, 0, 0}));
        ASSERT_TRUE(hit);
        EXPECT_LT(distance(Vec3d(hit->normal), normal), 1e-5);
        EXPECT_LT(distance(Vec3d(hit->tangent), {2, 0, 0}), 1e-4);
        // Along b = N x dp/du, v grows.
        const Vec3d b = normal.cross(Vec3d(1, 0, 0));
        const Vec3d aside = Vec3d(double{x}, 0, 0) + b * 0.2;
        const auto right = geometry.intersect(test::ray_between(aside + normal, aside));
        ASSERT_TRUE(right);
        EXPECT_NEAR(right->uv.y, 0.9, 1e-5);
        const Vec3d beyond = Vec3d(double{x}, 0, 0) + b * 0.26;
        EXPECT_FALSE(geometry.intersect(test::ray_between(beyond + normal, beyond)));
    }
}

/// Thin and long, bent, small and large, far off: rays that leave do not come back at once.
TEST(Curves, do_not_meet_themselves) {
    Dice dice(82);
    int hits = 0;
    int bad = 0;
    for (int i = 0; i < 300; ++i) {
        constexpr std::array<CurveKind, 3> kKinds{CurveKind::flat, CurveKind::cylinder,
                                                  CurveKind::ribbon};
        const CurveKind kind = kKinds.at(static_cast<std::size_t>(i % 3));
        const Curves curves = wild_curve(dice, kind, dice.magnitude(-3, -0.7));
        const double size = dice.magnitude(-3, 3);
        const Matrix matrix = test::scaling(size, size, size * dice.number(0.5, 2)) *
                              test::rotation(dice.direction(), dice.number(0, 6)) *
                              test::translation(dice.in_box(1) * size * dice.magnitude(-2, 1));
        const Geometry geometry = of_one(curves, matrix);
        const Bezier curve = curves.element(0).curve;
        for (int j = 0; j < 60; ++j) {
            const Vec3d target =
                Affine(matrix).point(evaluate(curve, dice.number(0.05, 0.95)).position);
            const Vec3d from = target + dice.direction() * size;
            const auto hit = geometry.intersect(test::ray_between(from, target));
            if (!hit) continue;
            ++hits;
            const Vec3 out = dice.direction_float();
            const auto next = geometry.intersect(test::leaving(*hit, out));
            if (!next) continue;
            // A flat strip has no sides to tell by: what is met must be farther off.
            const bool same = kind == CurveKind::flat
                                  ? next->distance < 2 * hit->error
                                  : hit->normal.dot(out) * next->normal.dot(out) > 1e-4F;
            bad += same ? 1 : 0;
        }
    }
    EXPECT_GT(hits, 10000);
    EXPECT_LE(bad, 2);  // a way into a tube, along it, may be missed: one in some thousands
}

TEST(Curves, instances_are_where_their_flattened_copies_are) {
    const Matrix inner = test::rotation({1, 1, 0}, 0.4) * test::scaling(1, 2, 1);
    const Matrix outer = test::scaling(1.5, -1, 0.5) * test::translation({1, 2, 3});
    for (const CurveKind kind : {CurveKind::flat, CurveKind::cylinder, CurveKind::ribbon}) {
        Dice dice(83);
        const Curves curves = wild_curve(dice, kind, 0.2);
        GeometryInput input;
        input.shapes.push_back({curves, inner, true});
        input.instances.push_back({{0}, outer, 0});
        const Geometry instanced(std::move(input));
        const Geometry flat = of_one(curves, inner * outer, true);
        int hits = 0;
        for (int i = 0; i < 3000; ++i) {
            const Vec3d to = Affine(inner * outer).point(dice.in_box(0.6));
            const Ray ray = test::ray_between(to + dice.direction() * 8, to);
            const auto a = instanced.intersect(ray);
            const auto b = flat.intersect(ray);
            ASSERT_EQ(a.has_value(), b.has_value());
            if (!a) continue;
            ++hits;
            EXPECT_LT(distance(Vec3d(a->position), Vec3d(b->position)), 1e-5);
            EXPECT_GT(a->normal.dot(b->normal), 0.9999);
            EXPECT_NEAR(a->error, b->error, 0.01 * double{b->error} + 1e-6);
        }
        EXPECT_GT(hits, 200);
    }
}

TEST(Curves, without_width_or_length_are_not_there) {
    EXPECT_FALSE(of_one(straight(CurveKind::flat, 0, 0)).intersect({{0, 0, 5}, {0, 0, -1}}));
    Curves point;
    point.segments = {{{Vec3(0), Vec3(0), Vec3(0), Vec3(0)}, {1, 1}}};
    for (const CurveKind kind : {CurveKind::flat, CurveKind::cylinder, CurveKind::ribbon}) {
        point.kind = kind;
        const auto hit = of_one(point).intersect({{0.1F, 0, 5}, {0, 0, -1}});
        EXPECT_TRUE(!hit || std::isfinite(hit->normal.x));
    }
}

}  // namespace
}  // namespace sunfleck::engine
