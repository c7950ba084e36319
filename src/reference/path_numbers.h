// The numbers of a path, in the order in which it asks: drawn afresh, or near those of another
// path.
//
// A path reads a prefix of its numbers. One near it moves those, and draws afresh what it reads
// beyond them: what was not read has no part in any target, so nothing needs to be kept of it.
#pragma once

#include "core/random.h"
#include "math/vector.h"

#include <vector>

namespace sunfleck::engine {

class PathNumbers {
public:
    explicit PathNumbers(RandomStream stream) : stream_(stream) {}
    /// @param near  null: all are drawn afresh. @param read  gets them, after what it holds; must
    /// be empty. Both outlive this.
    PathNumbers(RandomStream stream, const std::vector<double>* near, std::vector<double>* read)
        : stream_(stream), near_(near), read_(read) {}

    /// In (0,1).
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
