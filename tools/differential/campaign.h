// A series of scenes, examined one after the other or several at a time, and the report.
#pragma once

#include "differential/features.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine::differential {

struct Campaign {
    std::string program;
    std::string folder = "out/differential";
    std::uint32_t scenes = 200;
    std::uint32_t first = 0;
    std::uint64_t seed = 0;
    int jobs = 1;
    int seconds = 60;
    std::uint32_t bytes_every = 1;
    std::uint32_t discs_every = 8;
    int tries = 60;
    bool until_decided = false;
    bool keep = false;              // scenes without a fault
    std::vector<std::string> only;  // FEATURE=VALUE that a scene must have, else it is passed over
};

/// Prints a line for each fault and, at the end, the report, which goes to report.txt in the
/// folder, too. Scenes that fail stay in the folder, as they were made and minimised.
/// @return true if there was no fault.
bool run(const Campaign& campaign, const FeatureTable& table);

}  // namespace sunfleck::engine::differential
