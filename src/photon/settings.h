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
    bool guide_search = true;     // importons and edges look for it where chains fail
    bool light_strata = true;     // may part the lights
    bool adaptive_pixels = true;  // more camera paths where they are noisy
    PaperSettings paper;
};

/// A part of the sampler `adaptive` that can be left out.
struct AdaptivePart {
    bool PhotonSettings::*is_on;
    std::string_view name;  // of its flag, without "--"
};

/// As statistics and films have it: its name with '_' for '-'.
inline std::string setting_of(const AdaptivePart& part) {
    std::string setting(part.name);
    std::replace(setting.begin(), setting.end(), '-', '_');
    return setting;
}

inline constexpr std::array<AdaptivePart, 5> kAdaptiveParts = {{
    {&PhotonSettings::splitting, "splitting"},
    {&PhotonSettings::emission_guide, "emission-guide"},
    {&PhotonSettings::guide_search, "guide-search"},
    {&PhotonSettings::light_strata, "light-strata"},
    {&PhotonSettings::adaptive_pixels, "adaptive-pixels"},
}};

}  // namespace sunfleck::engine
