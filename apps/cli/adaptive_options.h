// The flags of the sampler `adaptive`: each switches one of its parts off.
#pragma once

#include "apps/cli/options.h"

#include <array>

namespace CLI {
class App;
}

namespace sunfleck::engine {

/// auto or off, by part; empty: not given.
using AdaptiveTexts = std::array<std::string, kAdaptiveParts.size()>;

/// --splitting, --emission-guide ...
std::string flag_of(const AdaptivePart& part);

void add_adaptive_flags(CLI::App& app, AdaptiveTexts& texts);

/// After the sampler is known.
/// @throws Error for a flag with another sampler, for a part of what is off, or for a balance of
///         paths whose number is given.
void finish_adaptive(const CLI::App& given, const AdaptiveTexts& texts, PhotonSettings& photon);

}  // namespace sunfleck::engine
