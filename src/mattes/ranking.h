// The IDs of a pixel by rank.
#pragma once

#include "mattes/matte_id.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

struct RankedId {
    MatteId id = kNoMatteId;
    std::uint32_t count = 0;  // of samples

    friend bool operator==(const RankedId&, const RankedId&) = default;
};

/// Returns each ID but kNoMatteId once, with its count: the most frequent first, equal ones by ID.
/// @param samples  are sorted.
std::vector<RankedId> ranked_ids(std::vector<MatteId>& samples);

}  // namespace sunfleck::engine
