// Makes a failing scene small: drops what it can while the scene still fails in the same way.
#pragma once

#include "differential/scene_text.h"

#include <functional>

namespace sunfleck::engine::differential {

/// Drops blocks, then statements, then parameters, from the last to the first, until nothing more
/// can go or the oracle was asked `most_tries` times.
/// @param still_fails  true if a smaller scene fails in the same way.
SceneText minimised(SceneText scene, const std::function<bool(const SceneText&)>& still_fails,
                    int most_tries);

}  // namespace sunfleck::engine::differential
