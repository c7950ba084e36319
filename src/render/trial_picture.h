// The picture of a trial: what is seen before the first pass.
#pragma once

#include "image/picture.h"
#include "planning/photon_trials.h"

namespace sunfleck::engine {

/// Returns a pixel for each camera path: light that needs no photon.
/// @param window  of the whole picture.
Picture trial_picture(const CameraTrial& trial, const PixelWindow& window);

}  // namespace sunfleck::engine
