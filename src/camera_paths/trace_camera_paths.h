// Camera paths of all pixels of a pass: they end in visible points, and in light that needs no
// photon.
//
// In:  the scene at a pass's wavelengths. Out: visible points; emission and direct light are added
// to the pass's image.
// Owners of light: docs/method/method.md has the table; visible_points/visible_point.h what photons
// bring.
#pragma once

#include "aovs/pass_image.h"
#include "aovs/statistics.h"
#include "camera_paths/camera_pass.h"
#include "visible_points/visible_point.h"

namespace sunfleck::engine {

/// All camera paths of all pixels. The order of the points, list after list, is that of the pixels.
VisiblePointLists trace_camera_paths(const CameraPass& pass, PassImage& image,
                                     Statistics& statistics);

}  // namespace sunfleck::engine
