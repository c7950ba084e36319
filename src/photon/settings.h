// What a user may choose about photon paths.
#pragma once

#include "photon/uniform_paths.h"

#include <optional>

namespace sunfleck {

struct PhotonSettings {
    UniformKind sampler = UniformKind::uniform;
    std::optional<std::uint32_t> paths_per_pass;  // absent: max(200,000, pixels)
};

}  // namespace sunfleck
