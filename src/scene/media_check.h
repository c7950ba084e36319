// Do the shapes of a scene agree about the media around them?
//
// A path keeps its medium until a surface names another one. Where the surfaces at the two ends of
// a way name different media, a path from the camera and one from a light go the same way through
// different media, and no estimator is right. Mostly that is a closed shape whose normals point
// into it, by ReverseOrientation or by how its triangles are wound, and whose media are named as if
// they pointed out of it.
#pragma once

#include "core/warnings.h"
#include "scene/media.h"
#include "scene/media_walks.h"
#include "scene/surfaces.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// Where the scene's file speaks of its shapes.
struct ScenePlaces {
    std::string path;                    // of the file
    std::vector<SourceLocation> shapes;  // by shape of the surfaces
};

/// Exchanges the media of closed shapes whose normals point inwards, where that makes them agree
/// with what is around them. Puts the camera and lights for which the scene names no medium into
/// the one through which they are seen. Warns of these, and of all that do not agree. A camera or
/// light for which the scene names a medium decides what is right; where there is none, the camera
/// stands in empty space. Found by walks (scene/media_walks.h); depends on the scene alone.
void mend_media(Surfaces& surfaces, Media& media, const PathOrigins& origins,
                const ScenePlaces& places, Warnings& warnings);

}  // namespace sunfleck::engine
