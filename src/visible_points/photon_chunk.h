// The photons of some paths, kept together so that they can be looked up in a good order.
#pragma once

#include "aovs/statistics.h"
#include "visible_points/visible_point.h"

#include <vector>

namespace sunfleck::engine {

/// Photon i belongs to path paths[i], a number within the pass or the chunk, and is marked in
/// taken[i] when deposited.
struct PhotonChunk {
    std::vector<Photon> photons;
    std::vector<std::uint32_t> paths;
    std::vector<std::uint8_t> taken;
    Statistics statistics;  // of tracing these paths

    /// No photons; the memory is kept.
    void clear() {
        photons.clear();
        paths.clear();
        taken.clear();
    }

    void reserve(std::size_t count) {
        photons.reserve(count);
        paths.reserve(count);
        taken.reserve(count);
    }

    void add(const Photon& photon, std::uint32_t path) {
        photons.push_back(photon);
        paths.push_back(path);
        taken.push_back(0);
    }

    /// Adds so many alike as one.
    void add_copies(const Photon& photon, std::uint32_t path, std::uint32_t copies) {
        add(photon, path);
        photons.back().copies = copies;
        photons.back().flux *= static_cast<float>(copies);
    }
};

}  // namespace sunfleck::engine
