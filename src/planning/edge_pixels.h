// Edge pixels: where discs may reach over the edge of a surface, so that passes probe them
// (camera_paths/edge_probes.h).
//
// In:  a trial, all of whose discs were probed. Out: pixels, or cells of the trial, with a disc
// that has more or less surface than area, and those around them; and where few discs were seen, so
// that nobody knows.
#pragma once

#include "camera_paths/camera_pass.h"
#include "planning/photon_trials.h"

namespace sunfleck::engine {

EdgePixels edge_pixels(const CameraTrial& seen, const PixelWindow& window);

}  // namespace sunfleck::engine
