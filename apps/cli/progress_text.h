// Texts about the progress of a render: passes, times and errors, cut to the width of a line.
#pragma once

#include "render/render_hooks.h"

#include <optional>
#include <string>

namespace sunfleck::engine {

/// Describes a picture, with its error where that is known: 64 passes, 11 s, error 1.9% (95% of
/// blocks).
std::string state_text(std::uint64_t passes, double seconds, std::optional<TargetError> error);

/// Says that the scene is being read, in at most `width` characters.
std::string reading_text(double seconds, std::size_t width);
/// Describes the progress in at most `width` characters, the most important parts first.
std::string progress_text(const Progress& progress, std::size_t width);

}  // namespace sunfleck::engine
