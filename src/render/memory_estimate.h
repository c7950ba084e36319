// Memory that a render needs, estimated before it begins.
#pragma once

#include "render/render_job.h"

#include <cstdint>

namespace sunfleck::engine {

/// Bytes beside the scene.
struct MemoryEstimate {
    std::uint64_t usual = 0;
    std::uint64_t most = 0;  // where all that can be noisy is: learned later, while it renders
};

/// Film, picture, visible points and photons of a pass. How measured peaks compare is in
/// docs/reference/render.md.
MemoryEstimate render_bytes(const RenderJob& job);

}  // namespace sunfleck::engine
