// Poses of animations: each interpolation between keys and beyond them.
#include "import/gltf/animations.h"

#include "gltf_files.h"

namespace sunfleck::engine {
namespace {

using testing_support::buffer_json;
using testing_support::bytes_of;

class GltfAnimation : public testing_support::GltfFiles {
protected:
    /// Members of a file with two keys, at 1 s and at 3 s, of one property of node 0.
    /// @param numbers  of all keys. @param type, count  of their accessor.
    static std::string keys(const std::vector<float>& numbers, const std::string& path,
                            const std::string& type, std::size_t count,
                            const std::string& interpolation) {
        return R"("scenes":[{"nodes":[0]}],"nodes":[{}],)" +
               buffer_json(bytes_of<float>({1, 3}) + bytes_of(numbers)) +
               R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"SCALAR","count":2},
{"bufferView":0,"byteOffset":8,"componentType":5126,"type":")" +
               type + R"(","count":)" + std::to_string(count) +
               R"(}],"animations":[{"samplers":[{"input":0,"output":1,"interpolation":")" +
               interpolation + R"("}],"channels":[{"sampler":0,"target":{"node":0,"path":")" +
               path + R"("}}]}])";
    }
    GltfPose pose(const std::string& members, double seconds) {
        const GltfDocument document(gltf(members));
        const Accessors accessors(document);
        return poses_at(seconds, document, accessors, warnings_).at(0);
    }

    Warnings warnings_;
};

TEST_F(GltfAnimation, moves_straight_between_keys_and_stands_beyond_them) {
    const std::string file = keys({0, 0, 0, 10, 20, 40}, "translation", "VEC3", 2, "LINEAR");
    EXPECT_EQ(*pose(file, 0).translation, Vec3d(0, 0, 0));
    EXPECT_EQ(*pose(file, 1.5).translation, Vec3d(2.5, 5, 10));
    EXPECT_EQ(*pose(file, 9).translation, Vec3d(10, 20, 40));
    EXPECT_FALSE(pose(file, 2).scale);
}

TEST_F(GltfAnimation, steps_at_keys) {
    const std::string file = keys({1, 1, 1, 2, 2, 2}, "scale", "VEC3", 2, "STEP");
    EXPECT_EQ(*pose(file, 2.999).scale, Vec3d(1));
    EXPECT_EQ(*pose(file, 3).scale, Vec3d(2));
}

/// From no turn to 120 degrees about z, given as the same rotation of the other sign: a quarter of
/// the way is 30 degrees.
TEST_F(GltfAnimation, turns_by_the_shorter_arc_at_even_speed) {
    const auto sine = std::sqrt(0.75F);
    const std::string file =
        keys({0, 0, 0, 1, 0, 0, -sine, -0.5F}, "rotation", "VEC4", 2, "LINEAR");
    const auto q = *pose(file, 1.5).rotation;
    EXPECT_NEAR(q[2], 0.2588190451, 1e-7);
    EXPECT_NEAR(q[3], 0.9659258263, 1e-7);
}

/// Value 0 with slope 1 per second, then value 4 with slope 3: Hermite's cubic at the middle.
TEST_F(GltfAnimation, bends_by_tangents) {
    const std::string file = keys({9, 9, 9, 0, 0, 0, 1, 1, 1, /**/ 3, 3, 3, 4, 4, 4, 9, 9, 9},
                                  "translation", "VEC3", 6, "CUBICSPLINE");
    EXPECT_NEAR(pose(file, 2).translation->x, 2 + 2 * (1 - 3) / 8.0, 1e-9);
    EXPECT_NEAR(pose(file, 1).translation->x, 0, 1e-9);
    EXPECT_NEAR(pose(file, 4).translation->x, 4, 1e-9);
}

TEST_F(GltfAnimation, weights_are_as_many_as_the_keys_have) {
    const std::string file = keys({0, 1, 0, 1, 0, 1}, "weights", "SCALAR", 6, "LINEAR");
    EXPECT_EQ(pose(file, 1.5).weights, (std::vector<double>{0.25, 0.75, 0.25}));
}

TEST_F(GltfAnimation, the_first_counts_where_two_move_the_same) {
    std::string file = keys({0, 0, 0, 10, 20, 40}, "translation", "VEC3", 2, "LINEAR");
    const std::string begin = R"("animations":[)";
    const std::string one = file.substr(file.find(begin) + begin.size());
    file.insert(file.size() - 1, "," + one.substr(0, one.size() - 1));
    EXPECT_EQ(*pose(file, 3).translation, Vec3d(10, 20, 40));
    ASSERT_EQ(warnings_.entries().size(), 1U);
    EXPECT_NE(warnings_.entries()[0].line().find("animations[1]: warning: moves what"),
              std::string::npos);
}

/// Each property by itself: the node keeps its own scale.
TEST_F(GltfAnimation, moves_nodes_in_the_scene) {
    std::string file = keys({5, 0, 0, 10, 20, 40}, "translation", "VEC3", 2, "LINEAR");
    file.replace(file.find("[{}]"), 4, R"([{"scale":[2,2,2],"translation":[1,1,1],"camera":0}])");
    ImportSettings settings;
    settings.frame_time = 3;
    const SceneDescription scene = read_gltf(
        gltf(file + R"(,"cameras":[{"type":"orthographic","orthographic":{"xmag":1,"ymag":1}}])"),
        settings);
    const CameraRay middle = camera_ray(scene.camera, {640, 640}, {0.5, 0.5});
    EXPECT_EQ(middle.origin.z, 40);
}

/// Exporters write a jump as two keys of one time: the later counts from there on.
TEST_F(GltfAnimation, may_jump) {
    const std::string members =
        buffer_json(bytes_of<float>({1, 2, 2, 3}) +
                    bytes_of<float>({0, 0, 0, 1, 1, 1, 5, 5, 5, 6, 6, 6})) +
        R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"SCALAR","count":4},
{"bufferView":0,"byteOffset":16,"componentType":5126,"type":"VEC3","count":4}],
"scenes":[{"nodes":[0]}],"nodes":[{}],"animations":[{"channels":[{"sampler":0,"target":
{"node":0,"path":"translation"}}],"samplers":[{"input":0,"output":1}]}])";
    EXPECT_EQ(pose(members, 1.5).translation->x, 0.5);
    EXPECT_EQ(pose(members, 2).translation->x, 5);
    EXPECT_EQ(pose(members, 2.5).translation->x, 5.5);
}

TEST_F(GltfAnimation, that_cannot_be_is_refused) {
    const std::string good = keys({0, 0, 0, 10, 20, 40}, "translation", "VEC3", 2, "LINEAR");
    EXPECT_EQ(fault_of(good), "");
    EXPECT_NE(fault_of(keys({0, 0, 0}, "translation", "VEC3", 1, "LINEAR")), "");
    EXPECT_EQ(fault_of(keys({0, 0, 0, 10, 20, 40}, "translation", "VEC3", 2, "SMOOTH")),
              "scene.gltf: animations[0].samplers[0].interpolation: is no interpolation; write "
              "LINEAR, STEP or CUBICSPLINE");
    std::string with_matrix = good;
    with_matrix.replace(with_matrix.find("[{}]"), 4,
                        R"([{"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}])");
    EXPECT_NE(fault_of(with_matrix), "");
}

}  // namespace
}  // namespace sunfleck::engine
