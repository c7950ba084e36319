// The scenes statue-far and statue-near: a polished knot of bronze on a pedestal.
#pragma once

#include "procedural/mesh.h"
#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Half the width and depth of the studio in cm. Its walls reflect light, so it sets the visible
/// fraction of statue-far (0.15 in the paper).
inline constexpr double kStudioHalfWidth = 205;

/// Field of view of the close-up in degrees. It sets the visible fraction of statue-near (1.8e-2 in
/// the paper, all light by photons).
inline constexpr double kNearFieldOfView = 15;

/// Returns about as many triangles as in Table I of Hachisuka and Jensen (2011). Unit: centimetres;
/// z is up. The two scenes differ in the camera alone. @param scene  its name ends in "near" for
/// the close-up.
std::vector<SceneFile> statue_scene(const ProceduralScene& scene);

/// Returns a closed fluted tube, twisted along a trefoil knot around the z axis.
Mesh fluted_knot(std::size_t along, std::size_t around);

}  // namespace sunfleck::engine
