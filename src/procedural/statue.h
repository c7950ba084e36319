// The scenes statue-far and statue-near: a polished knot of bronze on a pedestal.
#pragma once

#include "procedural/mesh.h"
#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Half the width and depth of the studio, cm: its walls send light back, so that it sets which
/// share of the photon paths is visible from far (0.15 in the paper).
inline constexpr double kStudioHalfWidth = 205;

/// Width of the close-up, degrees: it sets the share of statue-near (1.8e-2 in the paper,
/// all light by photons).
inline constexpr double kNearFieldOfView = 15;

/// About as many triangles as in Table I of Hachisuka and Jensen (2011). Centimetres, z up. The two
/// differ in the camera alone. @param scene  its name ends in "near" for the close-up.
std::vector<SceneFile> statue_scene(const ProceduralScene& scene);

/// A fluted tube, twisted along a trefoil knot around the z axis; closed.
Mesh fluted_knot(std::size_t along, std::size_t around);

}  // namespace sunfleck::engine
