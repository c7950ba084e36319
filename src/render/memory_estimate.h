// Memory that a render needs, estimated before it begins.
#pragma once

#include "render/progressive.h"

#include <cstdint>

namespace sunfleck {

/// Bytes beside the scene: film, picture, visible points and photons of a pass. Measured peaks are
/// .5 to 2 times as much (docs/render.md): how many camera paths noisy pixels get is learned
/// later.
std::uint64_t render_bytes(const RenderJob& job);

}  // namespace sunfleck
