// Ground and view of parts.
#include "import/part/surroundings.h"

#include "geometry/measure.h"
#include "scene/framing.h"

#include <gtest/gtest.h>

namespace sunfleck::engine {
namespace {

Bounds some_box() {
    Bounds box;
    box.min = {-1, 2, 3};
    box.max = {4, 5, 9};
    return box;
}

/// All that the picture shows behind the part is ground, and no horizon.
TEST(Surroundings, fill_the_picture_with_ground) {
    for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
        SceneDescription scene;
        TriangleMesh mesh;
        mesh.positions = {Vec3(some_box().min), Vec3(some_box().max), Vec3(0)};
        mesh.triangles = {{0, 1, 2}};
        scene.shapes.emplace_back().placed.shape = mesh;
        set_part_view(scene, up);
        add_ground(scene, bounds_of_scene(scene), up);
        const int axis = up == UpAxis::y ? 1 : 2;
        const Bounds ground = bounds_of(scene.shapes[1].placed);
        for (const Vec2d& film : {Vec2d(0, 0), Vec2d(1280, 0), Vec2d(640, 0), Vec2d(0, 720)}) {
            const CameraRay ray = camera_ray(scene.camera, film, {0.5, 0.5});
            ASSERT_LT(ray.direction[axis], 0);
            const double t = (ground.min[axis] - ray.origin[axis]) / ray.direction[axis];
            const Vec3d place = ray.origin + ray.direction * t;
            for (int c = 0; c < 3; ++c) {
                if (c == axis) continue;
                EXPECT_GT(place[c], ground.min[c]);
                EXPECT_LT(place[c], ground.max[c]);
            }
        }
    }
}

TEST(Surroundings, have_a_ground_that_faces_up_just_below) {
    for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
        SceneDescription scene;
        add_ground(scene, some_box(), up);
        const auto& mesh = std::get<TriangleMesh>(scene.shapes[0].placed.shape);
        const Triangle triangle = placed_triangle(mesh, Affine(scene.shapes[0].placed.to_world), 0);
        const int axis = up == UpAxis::y ? 1 : 2;
        EXPECT_GT(triangle.area_vector()[axis], 0);
        const double height = bounds_of(scene.shapes[0].placed).max[axis];
        EXPECT_LT(height, some_box().min[axis]);
        EXPECT_GT(height, some_box().min[axis] - 1e-3);
    }
}

}  // namespace
}  // namespace sunfleck::engine
