// Cameras of glTF, by what their rays see.
#include "import/gltf/view.h"

#include "gltf_files.h"

namespace sunfleck::engine {
namespace {

using testing_support::square_json;
using testing_support::warns;

class GltfView : public testing_support::GltfFiles {
protected:
    SceneDescription with(const std::string& camera, const std::string& node = "") const {
        return read(R"("cameras":[{)" + camera +
                    R"(}],"scenes":[{"nodes":[0]}],"nodes":[{"camera":0)" + node + "}]");
    }
    static Vec3d direction(const SceneDescription& scene, const Vec2d& film) {
        return camera_ray(scene.camera, film, {0.5, 0.5}).direction;
    }
};

/// yfov is the angle of the height; x goes right, y up, and -z ahead.
TEST_F(GltfView, perspective_looks_along_minus_z) {
    const SceneDescription scene =
        with(R"("type":"perspective","perspective":{"yfov":1.5707963267948966,"aspectRatio":2})");
    EXPECT_EQ(scene.film.resolution, Vec2i(1280, 640));
    EXPECT_LT((direction(scene, {640, 320}) - Vec3d(0, 0, -1)).length(), 1e-9);
    EXPECT_LT((direction(scene, {640, 0}) - Vec3d(0, 1, -1).normalized()).length(), 1e-9);
    EXPECT_LT((direction(scene, {1280, 320}) - Vec3d(2, 0, -1).normalized()).length(), 1e-9);
}

TEST_F(GltfView, a_tall_picture_has_the_same_height) {
    const SceneDescription scene =
        with(R"("type":"perspective","perspective":{"yfov":1.5707963267948966,"aspectRatio":0.5})");
    EXPECT_EQ(scene.film.resolution, Vec2i(360, 720));
    EXPECT_LT((direction(scene, {180, 0}) - Vec3d(0, 1, -1).normalized()).length(), 1e-9);
}

TEST_F(GltfView, cameras_move_with_their_node_and_are_not_scaled) {
    const SceneDescription scene =
        with(R"("type":"orthographic","orthographic":{"xmag":2,"ymag":1,"znear":0,"zfar":9})",
             R"(,"translation":[1,2,3],"scale":[5,5,5])");
    EXPECT_EQ(scene.film.resolution, Vec2i(1280, 640));
    const CameraRay corner = camera_ray(scene.camera, {0, 0}, {0.5, 0.5});
    EXPECT_LT((corner.origin - Vec3d(-1, 3, 3)).length(), 1e-9);
    EXPECT_LT((corner.direction - Vec3d(0, 0, -1)).length(), 1e-9);
}

TEST_F(GltfView, that_is_missing_sees_all_shapes) {
    const SceneDescription scene =
        read(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[100,0,0]}],)" +
             square_json());
    EXPECT_TRUE(warns(scene, "there is no camera"));
    const Vec3d centre(100.5, 0.5, 0);
    const CameraRay middle = camera_ray(scene.camera, {640, 360}, {0.5, 0.5});
    EXPECT_LT(middle.direction.cross(centre - middle.origin).length(), 1e-6);
    EXPECT_GT(middle.direction.dot(centre - middle.origin), 1);
}

TEST_F(GltfView, that_cannot_be_is_refused) {
    const std::string begin = R"("scenes":[{"nodes":[0]}],"nodes":[{"camera":0}],"cameras":[{)";
    EXPECT_EQ(fault_of(begin + R"("type":"fisheye"}])"),
              "scene.gltf: cameras[0].type: is no type of camera; write perspective or "
              "orthographic");
    EXPECT_NE(fault_of(begin + R"("type":"perspective","perspective":{"yfov":0}}])"), "");
    EXPECT_NE(fault_of(begin + R"("type":"perspective"}])"), "");
}

/// A mirrored or stretched parent turns the camera; it neither mirrors nor stretches its picture.
TEST_F(GltfView, scales_of_parents_change_where_cameras_stand_alone) {
    const SceneDescription scene = read(
        R"("cameras":[{"type":"perspective","perspective":{"yfov":1.5707963267948966,"aspectRatio":1}}],
"scenes":[{"nodes":[0]}],"nodes":[{"scale":[-2,3,4],"children":[1]},
{"camera":0,"translation":[1,1,1]}])");
    const CameraRay corner = camera_ray(scene.camera, {0, 0}, {0.5, 0.5});
    EXPECT_LT((corner.origin - Vec3d(-2, 3, 4)).length(), 1e-9);
    EXPECT_LT((Vec3d(corner.direction) - Vec3d(-1, 1, -1).normalized()).length(), 1e-6);
}

TEST_F(GltfView, a_camera_scaled_to_nothing_is_refused) {
    EXPECT_EQ(fault_of(R"("cameras":[{"type":"orthographic","orthographic":{"xmag":1,"ymag":1}}],
"scenes":[{"nodes":[0]}],"nodes":[{"camera":0,"scale":[0,0,0]}])"),
              "scene.gltf: nodes[0]: is scaled to nothing: its camera has no direction; choose "
              "another (--camera), or another time (--frame-time)");
}

}  // namespace
}  // namespace sunfleck::engine
