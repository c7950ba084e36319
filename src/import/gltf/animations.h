// Animations: the pose in which nodes stand at a time.
//
// Source: glTF 2.0 Specification, section 3.11 and appendix C (interpolation).
#pragma once

#include "core/warnings.h"
#include "import/gltf/accessors.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace sunfleck::engine {

/// What animations give a node in place of its own properties.
struct GltfPose {
    std::optional<Vec3d> translation{};
    std::optional<std::array<double, 4>> rotation{};  // quaternion x, y, z, w
    std::optional<Vec3d> scale{};
    std::vector<double> weights{};  // of morph targets; empty: its own
};

/// Poses by the number of their node; nodes that nothing moves are not listed.
using GltfPoses = std::map<std::size_t, GltfPose>;

/// Returns the poses of all animations at a time. Before the first key and after the last all
/// stands still. Where two animations move the same property, the first counts and a warning tells.
/// @param seconds  finite.
GltfPoses poses_at(double seconds, const GltfDocument& document, const Accessors& accessors,
                   Warnings& warnings);

}  // namespace sunfleck::engine
