// The scenes window-room and window-room-lamp: a closed room that the sun enters through a small
// pane of glass, without and with a lamp in it.
#pragma once

#include "procedural/mesh.h"
#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// Returns one file. Unit: metres; z is up. @param scene  one of both.
std::vector<SceneFile> window_room_scene(const ProceduralScene& scene);

/// Returns the walls: a closed surface (2 shells and the window's reveal), normals out of the
/// masonry.
Mesh room_walls();

/// Returns the pane: a closed slab, 6 mm thick, 1 cm of each edge within the wall.
Mesh window_pane();

}  // namespace sunfleck::engine
