// PhotonChunk: the photons of a range of paths, which are looked up together in Morton order.
#pragma once

#include "aovs/statistics.h"
#include "visible_points/visible_point.h"

#include <vector>

namespace sunfleck::engine {

/// Photon i belongs to path paths[i], an index within the pass or the chunk. taken[i] is set when
/// the photon is deposited.
struct PhotonChunk {
    std::vector<Photon> photons;
    std::vector<std::uint32_t> paths;
    std::vector<std::uint8_t> taken;
    Statistics statistics;  // of these paths

    /// Removes all photons and keeps the memory.
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

    /// Adds several identical photons as one.
    void add_copies(const Photon& photon, std::uint32_t path, std::uint32_t copies) {
        add(photon, path);
        photons.back().copies = copies;
        photons.back().flux *= static_cast<float>(copies);
    }
};

}  // namespace sunfleck::engine
