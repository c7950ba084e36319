// The relative square by which errors of pixels and blocks are weighed.
#pragma once

namespace sunfleck::engine {

/// Returns square / (reference^2 + 0.01 mean^2). @param mean  of the reference picture.
inline double relative_square(double square, double reference, double mean) {
    return square / (reference * reference + 0.01 * mean * mean);
}

}  // namespace sunfleck::engine
