// Camera paths of all pixels of a pass: they end in visible points, and in light that needs no
// photon.
//
// In:  the scene at a pass's wavelengths. Out: visible points; emission and direct light are added
// to the pass's image.
// Owners of light: docs/method.md has the table; measurement/visible_point.h what photons bring.
#pragma once

#include "eye/eye_pass.h"
#include "measurement/pass_image.h"
#include "measurement/statistics.h"
#include "measurement/visible_point.h"

namespace sunfleck {

/// All camera paths of all pixels. The order of the points, list after list, is that of the pixels.
VisiblePointLists trace_eye_paths(const EyePass& pass, PassImage& image, Statistics& statistics);

}  // namespace sunfleck
