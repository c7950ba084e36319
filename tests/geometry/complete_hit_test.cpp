// Hits on meshes: rays that leave do not come back; normals, flips, mirrors, tangents.
#include "geometry/ray.h"
#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

using test::Dice;
using test::distance;
using test::of_one;

/// A triangle of any size, place and shape, with its corners rounded to float.
TriangleMesh wild_triangle(Dice& dice) {
    const double size = dice.magnitude(-4, 4);
    const Vec3d center = dice.in_box(1) * size * dice.magnitude(-2, 4);
    const Vec3d along = dice.direction() * size;
    const Vec3d across = dice.direction() * size * dice.magnitude(-3, 0);
    const double foot = dice.number(-0.5, 1.5);
    return test::one_triangle(Vec3(center), Vec3(center + along),
                              Vec3(center + along * foot + across));
}

/// 1e5 rays from 2,500 triangles, in the world or in an instance, from both sides.
/// @return how many met the triangle that they left.
int count_self_hits(bool instanced, double share_of_error) {
    Dice dice(instanced ? 31 : 30);
    int bad = 0;
    int rays = 0;
    for (int i = 0; i < 2500; ++i) {
        GeometryInput input;
        input.shapes.push_back({wild_triangle(dice), Matrix(), false});
        Affine to_world;
        if (instanced) {
            const double size = dice.magnitude(-2, 2);
            const Matrix matrix = test::scaling(size, size * dice.magnitude(-1, 1), -size) *
                                  test::rotation(dice.direction(), dice.number(0, 6)) *
                                  test::translation(dice.in_box(1) * dice.magnitude(-2, 4));
            input.instances.push_back({{0}, matrix, 0});
            to_world = Affine(matrix);
        } else {
            input.in_world = {0};
        }
        const auto corners = std::get<TriangleMesh>(input.shapes[0].shape).positions;
        const Geometry geometry(std::move(input));
        const Vec3d p0 = to_world.point(Vec3d(corners[0]));
        const Vec3d e1 = to_world.point(Vec3d(corners[1])) - p0;
        const Vec3d e2 = to_world.point(Vec3d(corners[2])) - p0;
        for (int j = 0; j < 40; ++j) {
            const double u = dice.number(0, 1);
            const Vec3d target = p0 + e1 * u + e2 * dice.number(0, 1 - u);
            const Vec3d from = target + dice.direction() * e1.length();
            auto hit = geometry.intersect(test::ray_between(from, target));
            if (!hit) continue;
            hit->error = static_cast<float>(hit->error * share_of_error);
            ++rays;
            bad += geometry.intersect(test::leaving(*hit, dice.direction_float())) ? 1 : 0;
        }
    }
    EXPECT_GT(rays, 70000);
    return bad;
}

TEST(CompleteHit, rays_that_leave_a_triangle_never_meet_it_again) {
    EXPECT_EQ(count_self_hits(false, 1), 0);
}

TEST(CompleteHit, nor_in_an_instance) {
    EXPECT_EQ(count_self_hits(true, 1), 0);
}

/// The error is not far too large, either: a hundredth of it is not enough.
TEST(CompleteHit, the_error_is_needed) {
    EXPECT_GT(count_self_hits(false, 0.01), 100);
    EXPECT_GT(count_self_hits(true, 0.01), 100);
}

const TriangleMesh kUp = test::one_triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});  // towards +z

Hit middle(const Shape& shape, const Matrix& matrix, bool flip) {
    return of_one(shape, matrix, flip).intersect({{0, 0, 5}, {0, 0, -1}}).value();
}

TEST(CompleteHit, normals_follow_the_winding_and_stay_on_the_objects_side) {
    EXPECT_EQ(middle(kUp, Matrix(), false).normal, Vec3(0, 0, 1));
    EXPECT_EQ(middle(kUp, Matrix(), true).normal, Vec3(0, 0, -1));
    EXPECT_EQ(middle(kUp, test::scaling(-1, 1, 1), false).normal, Vec3(0, 0, 1));
    EXPECT_EQ(middle(kUp, test::scaling(-1, 1, 1), true).normal, Vec3(0, 0, -1));
    EXPECT_EQ(middle(kUp, test::scaling(1, 1, -1), false).normal, Vec3(0, 0, -1));
    EXPECT_EQ(middle(kUp, test::scaling(-1, -1, 1), false).normal, Vec3(0, 0, 1));
}

TEST(CompleteHit, given_normals_decide_the_side_and_flip_negates_them) {
    for (const bool flip : {false, true})
        for (const float side : {1.0F, -1.0F}) {
            TriangleMesh mesh = kUp;
            mesh.normals.assign(3, Vec3(0.6F, 0, 0.8F * side));
            const Hit hit = middle(mesh, Matrix(), flip);
            const float turned = flip ? -side : side;
            EXPECT_EQ(hit.normal, Vec3(0, 0, turned));
            EXPECT_NEAR(hit.shading_normal.z, 0.8F * turned, 1e-6);
            EXPECT_NEAR(hit.shading_normal.x, flip ? -0.6F : 0.6F, 1e-6);
            const Hit mirrored = middle(mesh, test::scaling(-1, 1, 1), flip);
            EXPECT_EQ(mirrored.normal, hit.normal);
            EXPECT_NEAR(mirrored.shading_normal.x, -hit.shading_normal.x, 1e-6);
        }
}

TEST(CompleteHit, spheres_and_disks_keep_their_outside_under_every_matrix) {
    for (const bool flip : {false, true})
        for (const double x : {1.0, -1.0}) {
            const float sign = flip ? -1 : 1;
            EXPECT_EQ(middle(Sphere{}, test::scaling(x, 1, 1), flip).normal, Vec3(0, 0, sign));
            EXPECT_EQ(middle(Sphere{}, test::scaling(1, 1, x), flip).normal, Vec3(0, 0, sign));
            EXPECT_EQ(middle(Disk{}, test::scaling(x, 1, 1), flip).normal, Vec3(0, 0, sign));
            EXPECT_EQ(middle(Disk{}, test::scaling(1, 1, x), flip).normal,
                      Vec3(0, 0, sign * static_cast<float>(x)));
        }
}

TEST(CompleteHit, a_shading_normal_without_length_or_along_the_surface_is_the_normal) {
    TriangleMesh mesh = kUp;
    mesh.normals.assign(3, Vec3(0));
    EXPECT_EQ(middle(mesh, Matrix(), false).shading_normal, Vec3(0, 0, 1));
    mesh.normals.assign(3, Vec3(1, 0, 0));
    EXPECT_EQ(middle(mesh, Matrix(), false).shading_normal, Vec3(0, 0, 1));
}

TEST(CompleteHit, coordinates_and_tangents) {
    const Hit plain = middle(kUp, Matrix(), false);  // weights 1/4, 1/4, 1/2; pbrt's default uvs
    EXPECT_EQ(plain.uv, Vec2(0.75F, 0.5F));
    EXPECT_LT(distance(Vec3d(plain.tangent), Vec3d(2, 0, 0)), 1e-6);
    TriangleMesh mesh = kUp;
    mesh.uvs = {{0, 0}, {0, 2}, {1, 1}};  // u along y, v along x
    const Hit turned = middle(mesh, test::scaling(1, 3, 1), false);
    EXPECT_LT(distance(Vec3d(turned.tangent), Vec3d(0, 6, 0)), 1e-5);
    mesh.tangents.assign(3, Vec3(1, 1, 0));
    EXPECT_LT(distance(Vec3d(middle(mesh, test::scaling(1, 3, 1), false).tangent), Vec3d(1, 3, 0)),
              1e-6);
}

}  // namespace
}  // namespace sunfleck::engine
