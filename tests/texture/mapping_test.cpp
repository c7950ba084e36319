// Mappings of points with known angles and places.
#include "texture/mapping.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

TexturePoint at(const Vec3& position, const Vec2& uv = {0, 0}) {
    return {position, {0, 0, 1}, uv};
}

void expect_near(const Vec2& seen, const Vec2& wanted) {
    EXPECT_NEAR(seen.x, wanted.x, 1e-6F);
    EXPECT_NEAR(seen.y, wanted.y, 1e-6F);
}

/// From a texture that stands at (1, 2, 3), twice as large.
Affine moved() {
    Affine map;
    map.x = {2, 0, 0};
    map.y = {0, 2, 0};
    map.z = {0, 0, 2};
    map.origin = {1, 2, 3};
    return map.inverse();
}

TEST(Mapping, uv_is_scaled_and_shifted) {
    expect_near(place(TurnedUvMapping{{0, 2}, {-3, 0}, {0.5F, -1}}, at({9, 9, 9}, {0.25F, 0.5F})),
                {1.5F, -1.75F});
    expect_near(place(UvMapping{{2, 3}, {0.5F, -1}}, at({9, 9, 9}, {0.25F, 0.5F})), {1, 0.5F});
}

TEST(Mapping, spherical_gives_polar_angle_and_azimuth) {
    const SphericalMapping plain;
    expect_near(place(plain, at({0, 0, 5})), {0, 0});
    expect_near(place(plain, at({0, 3, 0})), {0.5F, 0.25F});
    expect_near(place(plain, at({0, -1, -1})), {0.75F, 0.75F});
    expect_near(place(SphericalMapping{moved()}, at({1, 4, 3})), {0.5F, 0.25F});
}

TEST(Mapping, cylindrical_gives_azimuth_and_height) {
    const CylindricalMapping plain;
    expect_near(place(plain, at({1, 0, 7})), {0.5F, 7});
    expect_near(place(plain, at({0, 1, -2})), {0.75F, -2});
    expect_near(place(CylindricalMapping{moved()}, at({3, 2, 7})), {0.5F, 2});
}

TEST(Mapping, planar_is_by_products) {
    const PlanarMapping mapping{moved(), {1, 0, 2}, {0, 1, 0}, {10, 20}};
    expect_near(place(mapping, at({3, 4, 5})), {10 + 1 + 2, 20 + 1});
}

TEST(Mapping, point_goes_into_the_texture_frame) {
    EXPECT_EQ(PointMapping{moved()}.at(at({3, 4, 5})), Vec3(1, 1, 1));
}

}  // namespace
}  // namespace sunfleck::engine
