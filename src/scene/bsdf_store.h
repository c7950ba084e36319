// BsdfStore: Bsdfs that were evaluated at points of textured surfaces and are needed later in the
// pass.
#pragma once

#include "bsdf/bsdf.h"

#include <cstdint>
#include <deque>
#include <mutex>

namespace sunfleck::engine {

/// Any number of threads may add; reading starts when all have finished.
class BsdfStore {
public:
    /// @return the index of the copy.
    std::uint32_t add(const Bsdf& bsdf) {
        const std::lock_guard lock(guard_);
        bsdfs_.push_back(bsdf);
        return static_cast<std::uint32_t>(bsdfs_.size() - 1);
    }

    const Bsdf& operator[](std::size_t i) const { return bsdfs_[i]; }

private:
    std::mutex guard_;
    std::deque<Bsdf> bsdfs_;
};

}  // namespace sunfleck::engine
