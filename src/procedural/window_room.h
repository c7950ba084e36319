// The scenes window-room and window-room-lamp: a closed room that the sun enters through one small
// pane of glass, without a lamp in it and with one.
#pragma once

#include "procedural/mesh.h"
#include "procedural/scene_file.h"

#include <vector>

namespace sunfleck::engine {

/// One file. Metres, z up. @param scene  one of both.
std::vector<SceneFile> window_room_scene(const ProceduralScene& scene);

/// The walls: a closed surface (2 shells and the window's reveal), normals out of the masonry.
Mesh room_walls();

/// The pane: a closed slab, 6 mm thick, 1 cm of each edge within the wall.
Mesh window_pane();

}  // namespace sunfleck::engine
