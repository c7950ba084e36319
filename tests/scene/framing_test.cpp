// Cameras fitted to points, by where these land in the picture.
#include "scene/framing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sunfleck::engine {
namespace {

/// Returns the place of a point in the picture: (0, 0) its middle, 1 the right and upper edge.
Vec2d place_in(const PerspectiveCamera& camera, const Vec3d& point) {
    Vec3d local;
    camera.camera_to_world.inverse().multVecMatrix(point, local);
    return {local.x / local.z / camera.screen_max.x, local.y / local.z / camera.screen_max.y};
}

struct Extent {
    Vec2d least{1e9};
    Vec2d most{-1e9};
};

Extent extent_of(const Bounds& box, const PerspectiveCamera& camera) {
    Extent extent;
    for (int i = 0; i < 8; ++i) {
        const Vec3d corner((i & 1) != 0 ? box.max.x : box.min.x,
                           (i & 2) != 0 ? box.max.y : box.min.y,
                           (i & 4) != 0 ? box.max.z : box.min.z);
        const Vec2d place = place_in(camera, corner);
        extent.least = {std::min(extent.least.x, place.x), std::min(extent.least.y, place.y)};
        extent.most = {std::max(extent.most.x, place.x), std::max(extent.most.y, place.y)};
    }
    return extent;
}

Bounds box(const Vec3d& min, const Vec3d& max) {
    Bounds bounds;
    bounds.min = min;
    bounds.max = max;
    return bounds;
}

/// One of width and height is filled to both sides, the other is in the middle and no larger.
TEST(Framing, fills_the_picture_with_a_box_and_no_more) {
    Framing framing;
    framing.towards_camera = {0.5, 0.4, 1};
    for (const Vec3d& size : {Vec3d(1, 1, 1), Vec3d(20, 1, 1), Vec3d(1, 30, 1), Vec3d(2, 0, 9)}) {
        const Vec3d corner(100, -3, 7);
        const Bounds bounds = box(corner, corner + size);
        FramedView view(framing, {1280, 720}, {99, 0, 0});
        view.add(bounds);
        const Extent e = extent_of(bounds, view.camera());
        EXPECT_NEAR(std::max(e.most.x, e.most.y), framing.fill, 1e-9) << size.x;
        EXPECT_NEAR(std::min(e.least.x, e.least.y), -framing.fill, 1e-9) << size.x;
        EXPECT_LE(std::max({-e.least.x, -e.least.y, e.most.x, e.most.y}), framing.fill + 1e-9);
    }
}

TEST(Framing, sees_a_point_from_some_way_off) {
    FramedView view({}, {100, 100}, Vec3d(1));
    view.add(Vec3d(1));
    const PerspectiveCamera camera = view.camera(0.5);
    EXPECT_NEAR(place_in(camera, Vec3d(1)).length(), 0, 1e-9);
    EXPECT_EQ(camera.camera_to_world[3][2], 1.5);
}

TEST(Framing, counts_shapes_and_instances) {
    SceneDescription scene;
    EXPECT_TRUE(bounds_of_scene(scene).is_empty());
    ShapeDescription shape;
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    shape.placed.shape = mesh;
    scene.shapes.push_back(shape);
    scene.objects.push_back({shape});
    Matrix moved;
    moved[3][0] = 5;
    scene.instances.push_back({0, moved});
    EXPECT_EQ(bounds_of_scene(scene).min, Vec3d(0));
    EXPECT_EQ(bounds_of_scene(scene).max, Vec3d(6, 1, 0));
}

}  // namespace
}  // namespace sunfleck::engine
