// Do the shapes of a scene agree about the media around them?
//
// A path keeps its medium until a surface names another one. Where the surfaces at the two ends of
// a way name different media, a path from the camera and one from a light go the same way through
// different media, and no estimator is right. Mostly that is a closed shape whose normals point
// into it, by ReverseOrientation or by how its triangles are wound, and whose media are named as if
// they pointed out of it.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace sunfleck {

/// Exchanges the media of closed shapes whose normals point inwards, where that makes them agree
/// with what is around them, and warns of these and of all others that do not agree. Found by walks
/// from the camera: straight on through what can be passed, from other surfaces in any direction.
/// The result depends on the scene alone.
/// @param places  in the file, by shape of the scene. @param shapes  the scene's own.
void mend_media(const Scene& scene, const std::vector<SourceLocation>& places,
                std::vector<ShapeRecord>& shapes, Warnings& warnings);

}  // namespace sunfleck
