// Learns what decides who brings the light that comes straight from lights to media
// (camera_paths/direct_in_media.h).
//
// In:  a trial and its visible points, a plan of its photons. Out: photons of a pass per unit of
// volume where there are any, and how often light samples are lit.
#pragma once

#include "photon/light_stratum.h"
#include "planning/photon_trials.h"

#include <optional>

namespace sunfleck::engine {

/// Returns whether photons may bring a part of the light that comes straight from lights to media.
bool may_share_direct_light(const PassScene& pass, const TransportSettings& transport);

/// Returns nothing if no cylinder of the trial has met a photon that came straight from a light.
/// @param trial  a pass like the epoch's, without shares. @param seen  its trial.
/// @param plan  of a pass.
std::optional<DirectInMedia> learned_direct_in_media(const CameraPass& trial,
                                                     const CameraTrial& seen,
                                                     const std::vector<LightStratum>& plan,
                                                     const PilotName& name);

}  // namespace sunfleck::engine
