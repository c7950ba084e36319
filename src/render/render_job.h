// RenderJob: scene, settings and limits of a render, and the key of its films.
#pragma once

#include "film/film_key.h"
#include "scene/scene.h"
#include "stages/settings.h"

namespace sunfleck::engine {

/// scene_hash covers everything in the scene's files.
struct RenderJob {
    const Scene& scene;
    RenderSettings settings;
    StopSettings stop;
    std::uint64_t scene_hash = 0;
};

/// Returns the key that all shards of one render share.
FilmKey key_of(const RenderJob& job);

}  // namespace sunfleck::engine
