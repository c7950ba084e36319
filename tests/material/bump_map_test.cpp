// Relief: slopes whose normals are known, and what leaves a surface as it was.
#include "material/bump_map.h"

#include "texture/kinds.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

/// A plane of normal z; one of u is two units along x, one of v three along y.
const SurfaceDerivatives kPlane{{2, 0, 0}, {0, 3, 0}, Vec3(0), Vec3(0)};

Hit flat_hit() {
    Hit hit;
    hit.normal = hit.shading_normal = {0, 0, 1};
    hit.tangent = {2, 0, 0};
    hit.uv = {0.4F, 0.6F};
    return hit;
}

void expect_near(const Vec3& seen, const Vec3& wanted, float tolerance) {
    EXPECT_LT((seen - wanted).length(), tolerance) << seen << " for " << wanted;
}

FloatTexture rising(float along_u, float along_v) {
    return FloatTexture(
        FloatKind{BilerpKind<FloatTexture>{UvMapping{}, 0, along_v, along_u, along_u + along_v}});
}

TEST(Relief, a_slope_tilts_the_normal_as_much) {
    // Height a u + b v = a x / 2 + b y / 3 has the normal (-a/2, -b/3, 1).
    Hit hit = flat_hit();
    bend(Bumps{rising(0.6F, -0.3F)}, kPlane, hit);
    expect_near(hit.shading_normal, Vec3(-0.3F, 0.1F, 1).normalized(), 2e-4F);
    EXPECT_NEAR(hit.tangent.dot(hit.shading_normal), 0, 1e-3F);
    EXPECT_EQ(hit.normal, Vec3(0, 0, 1));
}

TEST(Relief, of_a_solid_texture_is_taken_along_the_surface) {
    // fbm at positions moved along dp/du: compared with the texture's own difference.
    const FloatTexture bumps(FloatKind{FbmKind{PointMapping{}, {2, 0.5F}}});
    Hit hit = flat_hit();
    hit.position = {0.3F, 0.7F, 0.2F};
    TexturePoint there(hit);
    const float height = bumps.at(there);
    there.position.x += 0.001F;
    const float slope_x = (bumps.at(there) - height) / 0.001F;
    there = TexturePoint(hit);
    there.position.y += 0.0015F;
    const float slope_y = (bumps.at(there) - height) / 0.0015F;
    bend(Bumps{bumps}, kPlane, hit);
    expect_near(hit.shading_normal, Vec3(-slope_x, -slope_y, 1).normalized(), 1e-3F);
}

TEST(Relief, on_a_curved_surface_counts_its_height) {
    // A sphere of radius 2 raised by 1 everywhere and by 0.3 u: dp/du grows by half.
    SurfaceDerivatives round = kPlane;
    round.dn_du = {1, 0, 0};
    round.dn_dv = {0, 1.5F, 0};
    const FloatTexture raised(FloatKind{BilerpKind<FloatTexture>{UvMapping{}, 1, 1, 1.3F, 1.3F}});
    Hit hit = flat_hit();
    hit.uv = {0, 0};
    bend(Bumps{raised}, round, hit);
    expect_near(hit.shading_normal, Vec3(-0.1F, 0, 1).normalized(), 2e-4F);
}

TEST(Relief, keeps_the_side_of_the_geometric_normal) {
    Hit hit = flat_hit();
    hit.normal = hit.shading_normal = {0, 0, -1};
    bend(Bumps{rising(0.6F, 0)}, kPlane, hit);
    expect_near(hit.shading_normal, Vec3(-0.3F, 0, -1).normalized(), 2e-4F);
}

NormalMap map_of(const Vec3& rgb) {
    return {std::make_shared<const Image>(Vec2i(1, 1), 3, std::vector<float>{rgb.x, rgb.y, rgb.z})};
}

TEST(Relief, normal_maps_are_in_the_frame_of_the_tangent) {
    Hit hit = flat_hit();
    bend(map_of({0.5F, 0.5F, 1}), kPlane, hit);
    expect_near(hit.shading_normal, {0, 0, 1}, 1e-6F);
    SurfaceDerivatives turned = kPlane;
    turned.dp_du = {0, 2, 0};
    turned.dp_dv = {-3, 0, 0};
    hit = flat_hit();
    bend(map_of({0.8F, 0.5F, 0.9F}), turned, hit);  // (0.6, 0, 0.8): along dp/du
    expect_near(hit.shading_normal, {0, 0.6F, 0.8F}, 1e-6F);
    EXPECT_NEAR(hit.tangent.dot(hit.shading_normal), 0, 1e-5F);
}

TEST(Relief, that_gives_no_normal_changes_nothing) {
    for (const Relief& relief :
         {Relief{}, Relief{Bumps{std::nanf("")}}, Relief{map_of({0.5F, 0.5F, 0.5F})}}) {
        Hit hit = flat_hit();
        bend(relief, kPlane, hit);
        EXPECT_EQ(hit.shading_normal, Vec3(0, 0, 1));
        EXPECT_EQ(hit.tangent, Vec3(2, 0, 0));
    }
}

}  // namespace
}  // namespace sunfleck::engine
