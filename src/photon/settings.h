// What a user may choose about photon paths.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace sunfleck {

/// Where the primary samples of photon paths come from.
enum class PhotonSampler { random, uniform, adaptive, paper };

struct PhotonSamplerRow {
    PhotonSampler sampler;
    std::string_view name;  // as the user writes it
    std::string_view what;
};

inline constexpr std::array<PhotonSamplerRow, 4> kPhotonSamplers = {{
    {PhotonSampler::adaptive, "adaptive", "Markov chains on the paths that can be seen"},
    {PhotonSampler::uniform, "uniform", "evenly spread over the lights"},
    {PhotonSampler::random, "random", "independent numbers, the paper's baseline"},
    {PhotonSampler::paper, "paper",
     "the paper's one chain over all passes, to the letter; biased at finite time"},
}};

constexpr std::string_view name_of(PhotonSampler sampler) {
    for (const PhotonSamplerRow& row : kPhotonSamplers)
        if (row.sampler == sampler) return row.name;
    return {};
}

/// Nothing for a name that no sampler has.
constexpr std::optional<PhotonSampler> sampler_named(std::string_view name) {
    for (const PhotonSamplerRow& row : kPhotonSamplers)
        if (row.name == name) return row.sampler;
    return {};
}

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
    bool noisy_pixels = true;   // of `adaptive`: more camera paths where they are noisy
    bool balance = true;        // of `adaptive`, if absent: from pass 16 on as measured
    bool light_groups = true;   // of the sampler `adaptive`: may part the lights
    bool emission_maps = true;  // of `adaptive`: may learn where light starts
    PaperSettings paper;
};

}  // namespace sunfleck
