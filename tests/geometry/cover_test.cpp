// Surfaces that are there in part: how many rays pass, that all who ask agree, and where.
#include "geometry/geometry.h"
#include "support.h"

#include <gtest/gtest.h>

namespace sunfleck::engine::test {
namespace {

TriangleMesh square(float z) {
    TriangleMesh mesh;
    mesh.positions = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

PlacedShape covered(Shape shape, Cover cover) {
    return {std::move(shape), Matrix(), false, std::move(cover)};
}

Cover always(float value) {
    return [value](const Hit&) { return value; };
}

Geometry world_of(std::vector<PlacedShape> shapes) {
    GeometryInput input;
    input.shapes = std::move(shapes);
    for (std::uint32_t i = 0; i < input.shapes.size(); ++i) input.in_world.push_back(i);
    return Geometry(std::move(input));
}

constexpr int kRays = 40'000;

/// The part of random rays from above that meets something.
double part_met(const Geometry& geometry, double from = 3) {
    Dice dice(1);
    int met = 0;
    for (int i = 0; i < kRays; ++i) {
        const Vec3 origin(Vec3d(dice.number(-0.9, 0.9), dice.number(-0.9, 0.9), from));
        const Ray ray{origin, {0, 0, -1}, kInfinity};
        const bool hit = geometry.intersect(ray).has_value();
        EXPECT_EQ(hit, geometry.occluded(ray));
        met += hit ? 1 : 0;
    }
    return met / static_cast<double>(kRays);
}

/// Five standard errors of a share p of the rays.
double bound(double p) {
    return 5 * std::sqrt(p * (1 - p) / kRays);
}

TEST(Cover, lets_its_share_of_rays_pass) {
    for (const float share : {0.0F, 0.25F, 0.5F, 1.0F})
        EXPECT_NEAR(part_met(world_of({covered(square(0), always(share))})), share,
                    bound(share) + 1e-12)
            << share;
}

TEST(Cover, of_several_sheets_is_independent) {
    const Geometry sheets =
        world_of({covered(square(0), always(0.5F)), covered(square(-1), always(0.5F)),
                  covered(Disk{-2, 2, 0, 2 * kPiDouble}, always(0.5F))});
    EXPECT_NEAR(part_met(sheets), 0.875, bound(0.875));
}

TEST(Cover, of_a_sphere_counts_both_its_sides) {
    const Geometry sphere =
        world_of({covered(Sphere{1.5, -1.5, 1.5, 2 * kPiDouble}, always(0.5F))});
    EXPECT_NEAR(part_met(sphere), 0.75, bound(0.75));
}

TEST(Cover, is_asked_at_the_place_of_the_hit) {
    const auto half = [](const Hit& hit) { return hit.uv.x < 0.5F ? 1.0F : 0.0F; };
    const auto left = [](const Hit& hit) { return hit.position.x < 0 ? 1.0F : 0.0F; };
    const Geometry cut = world_of({covered(square(0), half)});
    const Geometry round = world_of({covered(Sphere{1.2, -1.2, 1.2, 2 * kPiDouble}, left)});
    Dice dice(2);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 origin(Vec3d(dice.number(-0.7, 0.7), dice.number(-0.7, 0.7), 3));
        const Ray ray{origin, {0, 0, -1}, kInfinity};
        EXPECT_EQ(cut.intersect(ray).has_value(), origin.x < 0) << origin;
        EXPECT_EQ(round.occluded(ray), origin.x < 0) << origin;
    }
}

TEST(Cover, in_instances_is_that_of_the_object) {
    GeometryInput input;
    input.shapes = {covered(square(0), always(0.5F))};
    for (const double z : {0.0, -1.0}) input.instances.push_back({{0}, translation({0, 0, z}), 0});
    EXPECT_NEAR(part_met(Geometry(std::move(input))), 0.75, bound(0.75));
}

/// Such a ray is traced again from near the hit: it must still be the same ray.
TEST(Cover, of_a_far_ray_is_decided_once) {
    const Geometry sheet = world_of({covered(square(0), always(0.5F))});
    Dice dice(3);
    int met = 0;
    for (int i = 0; i < kRays; ++i) {
        const Vec3d origin(dice.number(-0.9, 0.9), dice.number(-0.9, 0.9), 1e5);
        met += sheet.intersect_precise(origin, {0, 0, -1}) ? 1 : 0;
    }
    EXPECT_NEAR(met / static_cast<double>(kRays), 0.5, bound(0.5));
}

}  // namespace
}  // namespace sunfleck::engine::test
