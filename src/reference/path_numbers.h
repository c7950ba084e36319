// The numbers of a path, in the order in which it asks: drawn afresh, or those of a Markov chain.
#pragma once

#include "core/random.h"
#include "math/vector.h"

namespace sunfleck {

class PathNumbers {
public:
    explicit PathNumbers(RandomStream stream) : stream_(stream) {}

    /// In (0,1).
    double next() { return stream_.next(); }
    float next_float() { return static_cast<float>(next()); }
    Vec2d next_two() {
        const double first = next();
        return {first, next()};
    }

private:
    RandomStream stream_;
};

}  // namespace sunfleck
