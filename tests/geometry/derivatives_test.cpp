// Derivatives of positions against differences of positions met by rays.
#include "geometry/geometry.h"
#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine::test {
namespace {

Geometry alone(Shape shape, const Matrix& to_world) {
    GeometryInput input;
    input.shapes = {{std::move(shape), to_world, false}};
    input.in_world = {0};
    return Geometry(std::move(input));
}

Hit met(const Geometry& geometry, const Vec3& origin, const Vec3& direction) {
    return geometry.intersect({origin, direction, kInfinity}).value();
}

/// Two rays that differ a little: the way between their hits is dp/du du + dp/dv dv.
void expect_linear(const Geometry& geometry, const Vec3& origin, const Vec3& direction) {
    const Hit here = met(geometry, origin, direction);
    const SurfaceDerivatives d = geometry.derivatives(here);
    for (const Vec3& step : {Vec3(1e-3F, 0, 0), Vec3(0, 1e-3F, 0)}) {
        const Hit there = met(geometry, origin + step, direction);
        const Vec2 uv = there.uv - here.uv;
        const Vec3 way = there.position - here.position;
        const Vec3 linear = d.dp_du * uv.x + d.dp_dv * uv.y;
        EXPECT_LT((way - linear).length(), 0.02F * way.length()) << way << ' ' << linear;
    }
}

TEST(Derivatives, follow_the_uvs) {
    const Matrix turned = rotation({1, 2, 3}, 0.7) * scaling(1, 2, 0.5) * translation({1, 0, 2});
    const auto check = [&](Shape shape, const Vec3d& from, const Vec3d& to) {
        const Vec3d start = from * turned;
        const Vec3d way = to * turned - start;
        expect_linear(alone(std::move(shape), turned), Vec3(start), Vec3(way.normalized()));
    };
    TriangleMesh mesh = one_triangle({-3, -3, 0}, {3, -3, 0.5F}, {0, 3, -0.5F});
    mesh.uvs = {{0.1F, 0.2F}, {0.9F, 0.3F}, {0.4F, 0.8F}};
    check(mesh, {0.2, 0.1, 5}, {0.2, 0.1, 0});
    mesh.uvs.clear();
    check(mesh, {0.2, 0.1, 5}, {0.2, 0.1, 0});
    check(Sphere{1, -0.8, 0.9, 5}, {1, 1.5, 0.6}, {0, 0, 0});
    check(Disk{0.5, 2, 0.25, 5}, {0.6, 0.9, 4}, {0.6, 0.9, 0.5});
}

TEST(Derivatives, of_an_instance_are_in_the_world) {
    GeometryInput input;
    input.shapes = {{Sphere{1, -1, 1, 2 * kPiDouble}, scaling(1, 1, 2), false}};
    input.instances.push_back({{0}, rotation({0, 1, 0}, 0.4) * translation({0.5, 0, 0}), 0});
    expect_linear(Geometry(std::move(input)), {0.7F, 0.3F, 9}, {0, 0, -1});
}

TEST(Derivatives, across_given_normals_are_perpendicular_and_of_one_length) {
    TriangleMesh mesh = one_triangle({0, 0, 0}, {2, 0, 0}, {0, 3, 0});
    mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
    mesh.normals = {{-0.3F, 0, 1}, {0.3F, 0, 1}, {-0.3F, 0, 1}};
    const Geometry geometry = alone(mesh, Matrix());
    const Hit hit = met(geometry, {0.9F, 0.1F, 3}, {0, 0, -1});
    const SurfaceDerivatives d = geometry.derivatives(hit);
    EXPECT_NEAR(d.dp_du.dot(hit.shading_normal), 0, 1e-5F);
    EXPECT_NEAR(d.dp_dv.dot(hit.shading_normal), 0, 1e-5F);
    EXPECT_NEAR(d.dp_du.length(), d.dp_dv.length(), 1e-5F);
    EXPECT_GT(d.dp_du.cross(d.dp_dv).dot(hit.shading_normal), 0);
    const float slant = 0.6F / std::sqrt(1.09F);
    EXPECT_LT((d.dn_du - Vec3(slant, 0, 0)).length(), 1e-6F) << d.dn_du;
    EXPECT_LT(d.dn_dv.length(), 1e-6F);
}

}  // namespace
}  // namespace sunfleck::engine::test
