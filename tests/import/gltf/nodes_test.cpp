// Frames of nodes: transforms in all forms, their order, and trees that are none.
#include "import/gltf/nodes.h"

#include "gltf_files.h"
#include "scene/scene.h"

namespace sunfleck::engine {
namespace {

using testing_support::buffer_json;
using testing_support::bytes_of;
using testing_support::square_json;
using testing_support::warns;

class GltfNodeTree : public testing_support::GltfFiles {
protected:
    /// Returns the frames of all nodes in the scene, instances each.
    std::vector<Matrix> frames_of(const std::string& members) const {
        const GltfDocument document(gltf(members));
        const Accessors accessors(document);
        const GltfNodes nodes(document, accessors);
        std::vector<Matrix> frames;
        for (const GltfNode& node : nodes.in_scene())
            for (const Matrix& frame : nodes.instances_of(node)) frames.push_back(frame);
        return frames;
    }
};

void expect_image(const Matrix& frame, const Vec3d& point, const Vec3d& image) {
    EXPECT_LT((point * frame - image).length(), 1e-6) << point * frame;
}

TEST_F(GltfNodeTree, scale_comes_before_rotation_before_translation) {
    // A quarter turn about z: x becomes y.
    const auto frames = frames_of(
        R"("scenes":[{"nodes":[0]}],"nodes":[{"scale":[2,3,4],"translation":[10,20,30],
"rotation":[0,0,0.70710678118,0.70710678118]}])");
    ASSERT_EQ(frames.size(), 1U);
    expect_image(frames[0], {1, 0, 0}, {10, 22, 30});
    expect_image(frames[0], {0, 1, 0}, {7, 20, 30});
    expect_image(frames[0], {0, 0, 1}, {10, 20, 34});
}

TEST_F(GltfNodeTree, matrices_are_given_column_by_column) {
    const auto frames = frames_of(
        R"("scenes":[{"nodes":[0]}],"nodes":[{"matrix":[0,2,0,0, -3,0,0,0, 0,0,4,0, 10,20,30,1]}])");
    expect_image(frames.at(0), {1, 0, 0}, {10, 22, 30});
    expect_image(frames.at(0), {0, 1, 0}, {7, 20, 30});
}

TEST_F(GltfNodeTree, children_are_in_the_frame_of_their_parent) {
    const auto frames = frames_of(R"("scene":1,"scenes":[{"nodes":[2]},{"nodes":[0]}],
"nodes":[{"children":[1],"translation":[1,0,0],"scale":[2,2,2]},{"translation":[0,5,0]},{}])");
    ASSERT_EQ(frames.size(), 2U) << "those of the chosen scene";
    expect_image(frames[1], {0, 0, 1}, {1, 10, 2});
}

TEST_F(GltfNodeTree, instances_have_frames_within_their_node) {
    const std::string bytes = bytes_of<float>({1, 0, 0, 0, 1, 0});
    const auto frames =
        frames_of(buffer_json(bytes) +
                  R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":2}],
"scenes":[{"nodes":[0]}],"nodes":[{"scale":[2,2,2],"extensions":{"EXT_mesh_gpu_instancing":
{"attributes":{"TRANSLATION":0}}}}])");
    ASSERT_EQ(frames.size(), 2U);
    expect_image(frames[0], {0, 0, 0}, {2, 0, 0});
    expect_image(frames[1], {0, 0, 1}, {0, 2, 2});
}

TEST_F(GltfNodeTree, loops_and_second_parents_are_refused) {
    EXPECT_EQ(fault_of(R"("scenes":[{"nodes":[0]}],"nodes":[{"children":[1]},{"children":[0]}])"),
              "scene.gltf: nodes[1].children[0]: makes node 0 part of the scene twice; give each "
              "node one parent");
    EXPECT_NE(fault_of(R"("scenes":[{"nodes":[0,0]}],"nodes":[{}])"), "");
    EXPECT_NE(fault_of(R"("scenes":[{"nodes":[1]}],"nodes":[{}])"), "");
    EXPECT_NE(fault_of(R"("scenes":[{"nodes":[0]}],"nodes":[{"rotation":[0,0,0,0]}])"), "");
    EXPECT_NE(fault_of(R"("scenes":[{"nodes":[0]}],"nodes":[{"scale":[1,2]}])"), "");
    EXPECT_EQ(fault_of(R"("scenes":[{"nodes":[0]}],"nodes":[{"translation":[1e300,0,0]}])"),
              "scene.gltf: nodes[0]: has a place or scale beyond 10^15; make the scene smaller");
}

/// No recursion: a chain of any length.
TEST_F(GltfNodeTree, may_be_deep) {
    constexpr int kDeep = 20'000;
    std::string members = R"("scenes":[{"nodes":[)";
    members += std::to_string(kDeep);
    members += R"(]}],"nodes":[{})";
    for (int i = 0; i < kDeep; ++i) {
        members += R"(,{"children":[)";
        members += std::to_string(i);
        members += "]}";
    }
    members += "]";
    EXPECT_EQ(frames_of(members).size(), kDeep + 1U);
}

/// All roots, where the file has no scene; the first scene, where it chooses none.
TEST_F(GltfNodeTree, without_a_scene_all_roots_are_shown) {
    const std::string nodes =
        R"("nodes":[{"translation":[1,0,0]},{"children":[2],"translation":[0,1,0]},{}])";
    EXPECT_EQ(frames_of(nodes).size(), 3U);
    EXPECT_EQ(frames_of(R"("scenes":[{"nodes":[1]},{"nodes":[0]}],)" + nodes).size(), 2U);
    EXPECT_EQ(frames_of(R"("scenes":[{}],)" + nodes).size(), 0U) << "an empty scene";
    EXPECT_EQ(fault_of(R"("nodes":[{"children":[1]},{"children":[0]}])"), "");
}

/// The file must not have both; the matrix counts.
TEST_F(GltfNodeTree, a_matrix_goes_before_translation_rotation_and_scale) {
    const auto frames = frames_of(
        R"("scenes":[{"nodes":[0]}],"nodes":[{"translation":[5,5,5],"scale":[9,9,9],
"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 10,20,30,1]}])");
    expect_image(frames.at(0), {1, 0, 0}, {11, 20, 30});
}

/// Returns what a ray along -z meets.
std::optional<Hit> seen(const SceneDescription& description, double x, double y) {
    const Scene scene(description);
    return scene.geometry().intersect(
        Ray{Vec3(Vec3d(x, y, 50) - scene.origin()), Vec3(0, 0, -1), 1000.0F});
}

TEST_F(GltfNodeTree, the_scene_that_is_shown_is_told_where_the_file_does_not_choose) {
    const std::string rest = R"("nodes":[{"mesh":0},{}],)" + square_json();
    const SceneDescription none = read(rest);
    EXPECT_EQ(none.shapes.size(), 1U);
    EXPECT_TRUE(warns(none, "scene.gltf: warning: has no scene: all its nodes are shown"));
    EXPECT_TRUE(warns(read(R"("scenes":[{"nodes":[0]},{"nodes":[1]}],)" + rest),
                      "has 2 scenes and chooses none: the first is shown"));
    const SceneDescription chosen =
        read(R"("scene":1,"scenes":[{"nodes":[1]},{"nodes":[0]}],)" + rest);
    EXPECT_EQ(chosen.shapes.size(), 1U);
    EXPECT_FALSE(warns(chosen, "scenes"));
}

/// Animations hide things so.
TEST_F(GltfNodeTree, what_is_scaled_to_nothing_is_left_out) {
    for (const char* scale : {"[0,0,0]", "[1,1,0]"}) {
        const SceneDescription scene =
            read(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":)" + std::string(scale) +
                 "}]," + square_json());
        EXPECT_TRUE(scene.shapes.empty()) << scale;
        EXPECT_TRUE(warns(scene, "nodes[0]: warning: is flat or too small, and left out"));
    }
}

TEST_F(GltfNodeTree, hidden_nodes_are_not_shown) {
    const std::string hidden = R"("extensions":{"KHR_node_visibility":{"visible":false}})";
    const std::string members =
        R"("extensionsUsed":["KHR_node_visibility"],"scenes":[{"nodes":[0,2]}],
"nodes":[{"children":[1],)" +
        hidden + R"(},{"mesh":0},{"mesh":0,"translation":[5,0,0]}],)" + square_json();
    const SceneDescription scene = read(members);
    EXPECT_FALSE(seen(scene, 0.4, 0.3));
    EXPECT_TRUE(seen(scene, 5.4, 0.3));
    EXPECT_TRUE(scene.instances.empty()) << "shown once";
    EXPECT_FALSE(warns(scene, "not read"));
}

/// Nodes of the same mesh are instances, others are shapes.
TEST_F(GltfNodeTree, names_of_nodes_or_meshes_are_those_of_objects) {
    const auto names = [&](const std::string& nodes) {
        return Scene(read(R"("scene":0,"scenes":[{"nodes":[0,1]}],"nodes":)" + nodes + ',' +
                          square_json()))
            .names();
    };
    EXPECT_EQ(names(R"([{"mesh":0,"name":"left"},{"mesh":0,"name":"right"}])").instances,
              (std::vector<std::string>{"left", "right"}));
    EXPECT_EQ(names(R"([{"mesh":0,"name":"left"},{"name":"empty"}])").shapes,
              (std::vector<std::string>{"left"}));
    EXPECT_EQ(names(R"([{"mesh":0},{"name":"empty"}])").shapes,
              (std::vector<std::string>{"mesh 0"}));
}

}  // namespace
}  // namespace sunfleck::engine
