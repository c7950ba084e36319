// PathNumbers: the random numbers of a path in the order of their use, new or mutated from another
// path.
//
// A path reads a prefix of its numbers. A mutated path perturbs those, and draws new ones beyond:
// unread numbers have no effect on the target, so they need not be stored.
#pragma once

#include "core/random.h"
#include "math/vector.h"

#include <vector>

namespace sunfleck::engine {

class PathNumbers {
public:
    explicit PathNumbers(RandomStream stream) : stream_(stream) {}
    /// @param near  numbers of the other path; null draws all anew.
    /// @param read  must be empty; receives the numbers in use. Both outlive this.
    PathNumbers(RandomStream stream, const std::vector<double>* near, std::vector<double>* read)
        : stream_(stream), near_(near), read_(read) {}

    /// Returns the next number in (0,1).
    double next() {
        if (read_ == nullptr) return stream_.next();
        const std::size_t i = read_->size();
        const double fresh = stream_.next();
        read_->push_back(near_ != nullptr && i < near_->size() ? moved((*near_)[i], fresh) : fresh);
        return read_->back();
    }
    Vec2d next_two() {
        const double first = next();
        return {first, next()};
    }

private:
    static double moved(double value, double u);

    RandomStream stream_;
    const std::vector<double>* near_ = nullptr;
    std::vector<double>* read_ = nullptr;
};

}  // namespace sunfleck::engine
