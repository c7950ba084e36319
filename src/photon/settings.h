// What a user may choose about photon paths.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sunfleck::engine {

/// Which sampler chooses the photon paths (photon_samplers/samplers.h).
enum class PhotonSampler { random, uniform, adaptive, paper, count };

/// Of the sampler `paper` alone: what its authors' experiments vary.
struct PaperSettings {
    bool replica_exchange = true;         // off: a plain chain
    std::optional<double> mutation_size;  // theta of eq. 9, positive; absent: adaptive (eq. 11)
    double target_acceptance = 0.234;     // A* of eq. 11, in (0,1)
};

struct PhotonSettings {
    PhotonSampler sampler = PhotonSampler::adaptive;
    /// Absent: 200,000, or two a pixel if these are more; of `paper` 200,000.
    std::optional<std::uint32_t> paths_per_pass;
    // Of the sampler `adaptive`:
    bool splitting = true;        // sets that lead to visible paths, where these are rare
    bool emission_guide = true;   // may learn where light starts
    bool guide_search = true;     // and look for it from the view, where chains do not lead there
    bool light_strata = true;     // may part the lights
    bool adaptive_pixels = true;  // more camera paths where they are noisy
    bool photon_budget = true;    // if paths_per_pass is absent: from pass 16 on as measured
    bool pass_weights = true;     // where passes are better by that, they count more
    PaperSettings paper;
};

/// A part of the sampler `adaptive` that can be left out.
struct AdaptivePart {
    bool PhotonSettings::*is_on;
    std::string_view name;  // as the user writes it
    std::string_view what;
};

/// As statistics and films have it: its name with '_' for '-'.
inline std::string setting_of(const AdaptivePart& part) {
    std::string setting(part.name);
    std::replace(setting.begin(), setting.end(), '-', '_');
    return setting;
}

inline constexpr std::array<AdaptivePart, 7> kAdaptiveParts = {{
    {&PhotonSettings::splitting, "splitting",
     "auto: where visible paths are rare, multilevel splitting towards them; off: one level, as in "
     "the paper"},
    {&PhotonSettings::emission_guide, "emission-guide",
     "auto: where visible paths are rare, learn where they start; off: Markov chains alone"},
    {&PhotonSettings::guide_search, "guide-search",
     "auto: where chains find no light, importons and edges look for it; off: chains alone"},
    {&PhotonSettings::light_strata, "light-strata",
     "auto: lights of unlike visible fractions are sampled as strata; off: all lights together"},
    {&PhotonSettings::adaptive_pixels, "adaptive-pixels",
     "auto: up to 64 camera paths per subpass in pixels whose measured noise is high; off: one per "
     "pixel"},
    {&PhotonSettings::photon_budget, "photon-budget",
     "auto: from pass 16 on, the number of photon paths per pass that trials found most efficient; "
     "off: the same number in all passes"},
    {&PhotonSettings::pass_weights, "pass-weights",
     "auto: passes are weighted by their inverse variance, up to four times; off: equally"},
}};

}  // namespace sunfleck::engine
