// Frames of nodes, from the roots down.
#include "import/gltf/nodes.h"

#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>

namespace sunfleck::engine {
namespace {

/// Returns the rotation of a quaternion (x, y, z, w), which need not be of length one.
Matrix rotation_of(const std::array<double, 4>& q, const JsonPlace& place) {
    const double length2 = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    if (!(length2 > 0)) place.refuse("is a rotation of length 0", "write 0, 0, 0, 1 for none");
    const double s = 2 / length2;
    const auto [x, y, z, w] = q;
    Matrix m;
    m[0][0] = 1 - s * (y * y + z * z);
    m[0][1] = s * (x * y + w * z);
    m[0][2] = s * (x * z - w * y);
    m[1][0] = s * (x * y - w * z);
    m[1][1] = 1 - s * (x * x + z * z);
    m[1][2] = s * (y * z + w * x);
    m[2][0] = s * (x * z + w * y);
    m[2][1] = s * (y * z - w * x);
    m[2][2] = 1 - s * (x * x + y * y);
    return m;
}

/// Scales, then rotates, then moves.
Matrix frame_of(const Vec3d& scale, const Matrix& rotation, const Vec3d& translation) {
    Matrix m = rotation;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) m[row][column] *= scale[row];
    for (int column = 0; column < 3; ++column) m[3][column] = translation[column];
    return m;
}

Matrix local_frame(const JsonPlace& node, const GltfPose& pose) {
    if (const auto matrix = node.find("matrix")) {
        if (pose.translation || pose.rotation || pose.scale)
            matrix->refuse("is a matrix of a node that is animated",
                           "give the node translation, rotation and scale");
        const std::vector<double> columns = matrix->numbers(16);
        Matrix m;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) m[i][j] = columns[static_cast<std::size_t>(4 * i + j)];
        return m;
    }
    std::array<double, 4> turn = {0, 0, 0, 1};
    if (const auto rotation = node.find("rotation")) {
        const std::vector<double> q = rotation->numbers(4);
        turn = {q[0], q[1], q[2], q[3]};
    }
    return frame_of(pose.scale.value_or(node.triple("scale", Vec3d(1))),
                    rotation_of(pose.rotation.value_or(turn), node),
                    pose.translation.value_or(node.triple("translation", Vec3d(0))));
}

/// @throws Error  for a frame that floats cannot hold.
void check_size(const JsonPlace& node, const Matrix& frame) {
    constexpr double kMost = 1e15;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            if (!(std::abs(frame[i][j]) <= kMost))
                node.refuse("has a place or scale beyond 10^15", "make the scene smaller");
}

/// Returns the number of each node's parent; nothing for a root.
std::vector<std::optional<std::size_t>> parents_of(const GltfDocument& document) {
    std::vector<std::optional<std::size_t>> parents(document.count("nodes"));
    const std::vector<JsonPlace> nodes = document.root().elements("nodes");
    for (std::size_t parent = 0; parent < nodes.size(); ++parent)
        for (const JsonPlace& child : nodes[parent].elements("children"))
            parents[child.index(nodes.size(), "node")] = parent;
    return parents;
}

/// A node to place, and the place that names it.
struct NamedNode {
    std::size_t number;
    JsonPlace place;
};

std::vector<NamedNode> named_in(const GltfDocument& document, const std::vector<JsonPlace>& names) {
    std::vector<NamedNode> nodes;
    for (const JsonPlace& name : names)
        nodes.push_back({name.index(document.count("nodes"), "node"), name});
    return nodes;
}

std::vector<NamedNode> roots_of(const GltfDocument& document) {
    const JsonPlace root = document.root();
    if (const auto chosen = root.find("scene"))
        return named_in(document, document.element("scenes", *chosen).elements("nodes"));
    const std::vector<JsonPlace> scenes = root.elements("scenes");
    if (!scenes.empty()) return named_in(document, scenes.front().elements("nodes"));
    const auto parents = parents_of(document);
    std::vector<NamedNode> roots;
    for (std::size_t i = 0; i < parents.size(); ++i)
        if (!parents[i]) roots.push_back({i, root.at("nodes")[i]});
    return roots;
}

/// Returns whether a node shows what hangs on it, if its parents do.
bool shows(const JsonPlace& node) {
    const auto visibility = node.extension("KHR_node_visibility");
    return !visibility || visibility->flag("visible", true);
}

const GltfPose& pose_of_node(const GltfPoses& poses, std::size_t number) {
    static const GltfPose kAtRest{};
    const auto posed = poses.find(number);
    return posed == poses.end() ? kAtRest : posed->second;
}

}  // namespace

GltfNodes::GltfNodes(const GltfDocument& document, const Accessors& accessors,
                     const GltfPoses& poses)
    : accessors_(accessors) {
    const std::size_t count = document.count("nodes");
    to_world_.resize(count);
    std::vector<bool> is_placed(count, false);
    struct Next {
        NamedNode node;
        Matrix parent;
        bool is_visible;
    };
    std::vector<Next> open;
    const auto add_all = [&](const std::vector<NamedNode>& nodes, const Matrix& parent,
                             bool is_visible) {
        for (std::size_t i = nodes.size(); i-- > 0;) open.push_back({nodes[i], parent, is_visible});
    };
    add_all(roots_of(document), Matrix(), true);
    while (!open.empty()) {
        const Next next = open.back();
        open.pop_back();
        const std::size_t number = next.node.number;
        if (is_placed[number])
            next.node.place.refuse(
                "makes node " + std::to_string(number) + " part of the scene twice",
                "give each node one parent");
        is_placed[number] = true;
        const JsonPlace node = document.root().at("nodes")[number];
        const GltfPose& pose = pose_of_node(poses, number);
        to_world_[number] = local_frame(node, pose) * next.parent;
        check_size(node, to_world_[number]);
        const bool is_visible = next.is_visible && shows(node);
        in_scene_.push_back({node, to_world_[number], pose.weights, is_visible});
        add_all(named_in(document, node.elements("children")), to_world_[number], is_visible);
    }
    place_joints(document, poses, is_placed);
}

/// Skins may name joints that are not in the scene.
void GltfNodes::place_joints(const GltfDocument& document, const GltfPoses& poses,
                             const std::vector<bool>& is_placed) {
    const std::size_t count = to_world_.size();
    std::set<std::size_t> outside;
    for (const JsonPlace& skin : document.root().elements("skins"))
        for (const NamedNode& joint : named_in(document, skin.elements("joints")))
            if (!is_placed[joint.number]) outside.insert(joint.number);
    if (outside.empty()) return;
    const auto parents = parents_of(document);
    for (const std::size_t joint : outside) {
        std::optional<std::size_t> node = joint;
        for (std::size_t step = 0; node; ++step, node = parents[*node]) {
            const JsonPlace place = document.root().at("nodes")[*node];
            if (step == count) place.refuse("is its own ancestor", "give each node one parent");
            to_world_[joint] *= local_frame(place, pose_of_node(poses, *node));
            check_size(place, to_world_[joint]);
        }
    }
}

std::vector<Matrix> GltfNodes::instances_of(const GltfNode& node) const {
    const auto extension = node.place.extension("EXT_mesh_gpu_instancing");
    if (!extension) return {node.to_world};
    const JsonPlace attributes = extension->at("attributes");
    std::vector<Vec3> translations;
    std::vector<Vec3> scales;
    std::vector<std::array<float, 4>> rotations;
    if (const auto a = attributes.find("TRANSLATION")) translations = accessors_.triples(*a);
    if (const auto a = attributes.find("SCALE")) scales = accessors_.triples(*a);
    if (const auto a = attributes.find("ROTATION")) rotations = accessors_.quadruples(*a);
    const std::size_t count = std::max({translations.size(), scales.size(), rotations.size()});
    const auto fits = [&](std::size_t size) { return size == 0 || size == count; };
    if (!fits(translations.size()) || !fits(scales.size()) || !fits(rotations.size()))
        attributes.refuse("differ in their number of instances", "export the file again");
    std::vector<Matrix> frames;
    for (std::size_t i = 0; i < count; ++i) {
        std::array<double, 4> turn = {0, 0, 0, 1};
        for (std::size_t c = 0; c < 4 && !rotations.empty(); ++c)
            turn.at(c) = static_cast<double>(rotations[i].at(c));
        const Vec3d scale = scales.empty() ? Vec3d(1) : Vec3d(scales[i]);
        const Vec3d place = translations.empty() ? Vec3d(0) : Vec3d(translations[i]);
        frames.push_back(frame_of(scale, rotation_of(turn, attributes), place) * node.to_world);
    }
    return frames;
}

}  // namespace sunfleck::engine
