// Camera pass: traces the camera paths of all pixels.
//
// In:  the scene at the wavelengths of a pass. Out: visible points; emission and direct light are
// added to the image of the pass.
// docs/method/method.md has the path-space partition; visible_points/visible_point.h says which
// light photons bring.
#pragma once

#include "aovs/pass_image.h"
#include "aovs/statistics.h"
#include "camera_paths/camera_pass.h"
#include "visible_points/visible_point.h"

namespace sunfleck::engine {

/// Traces all camera paths. The concatenated lists of visible points are in pixel order.
VisiblePointLists trace_camera_paths(const CameraPass& pass, PassImage& image,
                                     Statistics& statistics);

}  // namespace sunfleck::engine
