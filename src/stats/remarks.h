// What is to be said of a render beside its picture: a line for each thing that may make the
// picture other than expected.
#pragma once

#include "render/render_job.h"
#include "render/render_state.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

inline constexpr const char* kNoAvx2 =
    "this machine has no AVX2: bytes may differ from those of other machines";

/// Returns what is known before the render: warnings of the scene, bytes that may differ, bias.
/// @param isa  that the scene was built with.
std::vector<std::string> remarks_before(const RenderJob& job, const std::string& isa);

/// Returns what the picture tells: light that is missing, errors that are not known, time that was
/// too short.
std::vector<std::string> remarks_after(const RenderJob& job, const RenderResult& result);

}  // namespace sunfleck::engine
