// What a render is of: a scene, settings and limits; and the key by which films of it are known.
#pragma once

#include "film/film_key.h"
#include "scene/scene.h"
#include "stages/settings.h"

namespace sunfleck::engine {

/// What a render is to be compared by: scene_hash is of all that the scene's files hold.
struct RenderJob {
    const Scene& scene;
    RenderSettings settings;
    StopSettings stop;
    std::uint64_t scene_hash = 0;
};

/// What parts of one render have in common.
FilmKey key_of(const RenderJob& job);

}  // namespace sunfleck::engine
