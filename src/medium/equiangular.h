// Equiangular: distances along a way, even in the angle under which a point beside it sees them.
//
// Light of a lamp falls as the square of the distance from it, which this density cancels.
// In:  a way, whose length may be infinite; a point, such as one on a lamp. Out: distances with
// their density. Source: Kulla and Fajardo, Importance sampling techniques for path tracing in
// participating media (EGSR 2012).
#pragma once

#include "geometry/ray.h"

#include <algorithm>
#include <cmath>

namespace sunfleck::engine {

class Equiangular {
public:
    Equiangular(const Ray& way, const Vec3& point)
        : length_(way.length), nearest_((point - way.origin).dot(way.direction)) {
        // A point right on the way would be met alone.
        constexpr float kLeastHeight = 1e-3F;
        const Vec3 from = point - way.origin;
        const Vec3 across = from - way.direction * nearest_;
        height_ = std::max({across.length(), kLeastHeight * from.length(), 1e-30F});
        begin_ = std::atan(-nearest_ / height_);
        end_ = std::atan((length_ - nearest_) / height_);
    }

    /// @param u  in [0,1). @return a distance below the length.
    float distance_at(float u) const {
        const float angle = begin_ + u * (end_ - begin_);
        return std::clamp(nearest_ + height_ * std::tan(angle), 0.0F, length_);
    }
    float density(float distance) const {
        const float beyond = distance - nearest_;
        return height_ / ((end_ - begin_) * (height_ * height_ + beyond * beyond));
    }

private:
    float length_;
    float nearest_;  // distance of what is nearest to the point
    float height_;   // of the point above it
    float begin_;    // angles
    float end_;
};

}  // namespace sunfleck::engine
