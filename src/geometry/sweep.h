// A sector of azimuths around the z axis: which points are in it, without arc tangents.
#pragma once

#include "math/trigonometry.h"
#include "math/vector.h"

#include <algorithm>

namespace sunfleck::engine {

inline constexpr double kFullCircle = 2 * kPiDouble;

/// Within 2^-50. @param angle  radians, at most a turn either way.
inline SinCos sin_cos(double angle) {
    return sin_cos_2pi(angle / kFullCircle);
}

/// Azimuths of [0, phi_max]; phi_max is brought into [0, 2 pi].
class Sweep {
public:
    explicit Sweep(double phi_max)
        : angle_(std::clamp(phi_max, 0.0, kFullCircle)),
          is_full_(angle_ > kFullCircle * (1 - 1e-9)) {
        if (!is_full_) end_ = sin_cos(angle_);
    }

    double angle() const { return angle_; }

    /// Is the azimuth of (x, y) inside, both ends included? By the side of the two end rays.
    bool contains(double x, double y) const {
        if (is_full_) return true;
        const bool after_start = y >= 0;
        const bool before_end = end_.cos * y <= end_.sin * x;
        if (angle_ <= kPiDouble) return after_start && before_end;
        return after_start || before_end;
    }

private:
    double angle_;
    bool is_full_;
    SinCos end_;
};

/// Azimuth of (x, y) in [0, 2 pi), to float precision.
float azimuth(double x, double y);

}  // namespace sunfleck::engine
