// Consistency of media: whether the shapes of a scene agree on the media between them.
//
// A path stays in its medium until a surface names another one. If the surfaces at both ends of a
// segment name different media, a camera path and a photon path cross the same segment in different
// media, and no estimator is right. The usual cause is a closed shape whose normals point inwards,
// by ReverseOrientation or by its winding, while its media are named as if they pointed outwards.
#pragma once

#include "core/warnings.h"
#include "scene/media.h"
#include "scene/media_walks.h"
#include "scene/surfaces.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// Locations of the shapes in the scene file.
struct ScenePlaces {
    std::string path;                    // of the file
    std::vector<SourceLocation> shapes;  // per shape
};

/// Exchanges the media of closed shapes whose normals point inwards, if that makes them consistent
/// with their surroundings. Assigns the camera, and lights without a named medium, to the medium
/// through which they are seen. Warns of these changes, and of shapes that remain inconsistent. A
/// camera or light with a named medium is taken as right; without any, the camera is in empty
/// space. Decisions are made by random walks (scene/media_walks.h) that depend on the scene alone.
/// @return  the shapes whose media were exchanged.
std::vector<std::uint32_t> mend_media(Surfaces& surfaces, Media& media, const PathOrigins& origins,
                                      const ScenePlaces& places, Warnings& warnings);

}  // namespace sunfleck::engine
