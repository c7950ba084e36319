// How far a render is, in words: times, errors, and as much of both as a line holds.
#pragma once

#include "render/render_hooks.h"

#include <optional>
#include <string>

namespace sunfleck::engine {

/// In whole seconds: 7 s, 3m12s, 2h05m.
std::string duration_text(double seconds);
/// What a picture is, with its error where that is known: 64 passes, 11 s, error 1.9% (95% of
/// blocks).
std::string state_text(std::uint64_t passes, double seconds, std::optional<TargetError> error);

/// That the scene is being read, in a line of at most `width` characters.
std::string reading_text(double seconds, std::size_t width);
/// As much of the progress as a line of `width` characters holds, what matters most first.
std::string progress_text(const Progress& progress, std::size_t width);

}  // namespace sunfleck::engine
