// Learning of an epoch.
//
// In:  scene, settings, a pass. Out: its epoch. Who brings indirect light is learned from trials of
// the first pass; trials of worth go on from epoch to epoch, and each takes them anew unless it is
// told those of an earlier one; all else is learned from visible points like those of the epoch's
// first pass alone. So any pass can be rendered anywhere, without earlier ones. Trials are no part
// of the picture: an allocation computed from the pass itself would bias it.
#pragma once

#include "planning/epoch.h"
#include "stages/settings.h"

#include <functional>

namespace sunfleck::engine {

/// Returns whether pilots and trials have to run. If not, all epochs are the same but for their
/// numbers.
bool needs_learning(const Scene& scene, const RenderSettings& settings);

/// Returns the epoch of a pass. Small passes do not ask which pixels need more camera paths, and do
/// not wait for the answer: their epoch serves() no others, and is what theirs is made of.
/// @param trial_traced  called long before learning ends.
/// @param before  an earlier epoch of the same render, or that of small passes: saves what was
///                learned for it, and changes nothing.
Epoch learn_epoch(const Scene& scene, const RenderSettings& settings, std::uint32_t pass,
                  const TrialTraced& trial_traced = {}, const Epoch* before = nullptr);

/// Returns whether a pass can be rendered by this epoch.
bool serves(const Epoch& epoch, const Scene& scene, const RenderSettings& settings,
            std::uint32_t pass);

}  // namespace sunfleck::engine
