// Photons of a chain's states, each with the number of steps that its state stood.
#pragma once

#include "measurement/visible_point.h"

#include <vector>

namespace sunfleck {

/// Photon i counts repeats[i] times.
struct RepeatedPhotons {
    std::vector<Photon> photons;
    std::vector<std::uint32_t> repeats;

    void add(const Photon& photon, std::uint32_t times) {
        photons.push_back(photon);
        repeats.push_back(times);
    }
};

}  // namespace sunfleck
