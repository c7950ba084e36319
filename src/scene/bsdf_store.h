// Bsdfs that were made for single points of a pass and are needed later in it.
#pragma once

#include "bsdf/bsdf.h"

#include <cstdint>
#include <deque>
#include <mutex>

namespace sunfleck::engine {

/// Grows by any number of threads; is read when all growing has ended.
class BsdfStore {
public:
    /// @return where it is found.
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
