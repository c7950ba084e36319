// The flags of the sampler `adaptive`: each switches one of its parts off.
#pragma once

#include "apps/cli/options.h"

namespace CLI {
class App;
}

namespace sunfleck {

/// auto or off.
struct AdaptiveTexts {
    std::string light_groups = "auto";
    std::string emission_maps = "auto";
    std::string noisy_pixels = "auto";
    std::string balance = "auto";
};

void add_adaptive_flags(CLI::App& app, AdaptiveTexts& texts);

/// After the sampler is known.
/// @throws Error for a flag with another sampler, or for a balance of paths whose number is given.
void finish_adaptive(const CLI::App& given, const AdaptiveTexts& texts, PhotonSettings& photon);

}  // namespace sunfleck
