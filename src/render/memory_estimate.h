// Estimate of the memory that a render needs, before it begins.
#pragma once

#include "render/render_job.h"

#include <cstdint>

namespace sunfleck::engine {

/// Bytes besides the scene.
struct MemoryEstimate {
    std::uint64_t usual = 0;
    std::uint64_t most = 0;  // if all pixels need more camera paths; known after learning
};

/// Returns the channels of the AOVs and light groups that are asked for.
std::uint64_t asked_channels(const RenderSettings& settings);

/// Estimates film, picture, visible points and photons of a pass. docs/reference/render.md compares
/// it with measured peaks.
MemoryEstimate render_bytes(const RenderJob& job);

}  // namespace sunfleck::engine
