// The scene of the benchmarks: a closed room with a bumpy floor, of any number of triangles.
#pragma once

#include "scene/description.h"

namespace sunfleck::engine::bench {

struct RoomSettings {
    std::size_t triangles = 131'072;  // of the floor, about
    Vec2i resolution{512, 512};
};

/// Diffuse walls of albedo 0.7, a ceiling lamp, the camera in one corner. Nothing can escape.
SceneDescription bumpy_room(const RoomSettings& settings);

}  // namespace sunfleck::engine::bench
