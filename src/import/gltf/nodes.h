// Nodes: the tree of a glTF scene, as things with their places in the world.
//
// Source: glTF 2.0 Specification, section 3.5; EXT_mesh_gpu_instancing.
#pragma once

#include "import/gltf/animations.h"
#include "math/vector.h"

#include <vector>

namespace sunfleck::engine {

/// A node of the scene, and its frame.
struct GltfNode {
    JsonPlace place;
    Matrix to_world;
    std::vector<double> weights{};  // of morph targets, by animations; empty: its own
    bool is_visible = true;         // KHR_node_visibility, and that of all its parents
};

class GltfNodes {
public:
    /// Places all nodes of the scene that the file chooses (its first if it chooses none; all roots
    /// without scenes), in the poses that animations give them.
    /// @throws Error  for nodes with two parents, a loop among them.
    GltfNodes(const GltfDocument& document, const Accessors& accessors,
              const GltfPoses& poses = {});

    /// Returns the nodes of the scene, parents first.
    const std::vector<GltfNode>& in_scene() const { return in_scene_; }
    /// Returns the frame of a node that is in the scene or a joint of a skin, by its number.
    const Matrix& to_world(std::size_t node) const { return to_world_[node]; }

    /// Returns the frames of a node's instances: its own unless EXT_mesh_gpu_instancing has others.
    std::vector<Matrix> instances_of(const GltfNode& node) const;

private:
    void place_joints(const GltfDocument& document, const GltfPoses& poses,
                      const std::vector<bool>& is_placed);

    const Accessors& accessors_;
    std::vector<GltfNode> in_scene_;
    std::vector<Matrix> to_world_;
};

}  // namespace sunfleck::engine
