// Frames of nodes, from the roots down.
#include "import/gltf/nodes.h"

#include <array>
#include <cmath>

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

/// Returns the numbers of the scene's roots.
std::vector<JsonPlace> roots_of(const GltfDocument& document) {
    const JsonPlace root = document.root();
    if (const auto chosen = root.find("scene"))
        return document.element("scenes", *chosen).elements("nodes");
    const std::vector<JsonPlace> scenes = root.elements("scenes");
    return scenes.empty() ? std::vector<JsonPlace>() : scenes.front().elements("nodes");
}

}  // namespace

GltfNodes::GltfNodes(const GltfDocument& document, const Accessors& accessors,
                     const GltfPoses& poses)
    : accessors_(accessors) {
    static const GltfPose kAtRest{};
    const std::size_t count = document.count("nodes");
    to_world_.resize(count);
    std::vector<bool> is_placed(count, false);
    struct Next {
        JsonPlace number;
        Matrix parent;
    };
    std::vector<Next> open;
    const auto add_all = [&](const std::vector<JsonPlace>& numbers, const Matrix& parent) {
        for (std::size_t i = numbers.size(); i-- > 0;) open.push_back({numbers[i], parent});
    };
    add_all(roots_of(document), Matrix());
    while (!open.empty()) {
        const Next next = open.back();
        open.pop_back();
        const std::size_t number = next.number.index(count, "node");
        if (is_placed[number])
            next.number.refuse("makes node " + std::to_string(number) + " part of the scene twice",
                               "give each node one parent");
        is_placed[number] = true;
        const JsonPlace node = document.element("nodes", next.number);
        const auto posed = poses.find(number);
        const GltfPose& pose = posed == poses.end() ? kAtRest : posed->second;
        to_world_[number] = local_frame(node, pose) * next.parent;
        check_size(node, to_world_[number]);
        in_scene_.push_back({node, to_world_[number], pose.weights});
        add_all(node.elements("children"), to_world_[number]);
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
