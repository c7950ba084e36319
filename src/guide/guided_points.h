// GuidedPoints: primary samples whose emission dimensions are mapped by a guide, weighted by one
// over its density, or by a bound where that is more.
//
// In:  a pass, a guide fixed before it, the index of a path. Out: a primary-sample reader, and the
// weight of the sample.
#pragma once

#include "guide/emission_guide.h"
#include "random_numbers/emission_points.h"

#include <algorithm>
#include <array>
#include <limits>

namespace sunfleck::engine {

/// A bound of weights that leaves nothing.
inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

class GuidedPoints {
public:
    /// @param pass  its own uniform points are independent of these. @param map  must outlive this.
    /// @param most_weight  the bound: chains bring what it leaves.
    GuidedPoints(PassId pass, const EmissionGuide& map, double most_weight = kUnbounded)
        : points_(pass.with_stratum(PassId::kStrata / 2)), guide_(map), most_weight_(most_weight) {}

    class Reader {
    public:
        std::uint64_t operator()(std::uint32_t index) {
            return index < kGuidedDimensions ? emission_[index] : rest_(index);
        }
        double weight() const { return std::min(weight_, most_weight_); }
        double unbounded_weight() const { return weight_; }
        bool is_bounded() const { return weight_ > most_weight_; }

    private:
        friend class GuidedPoints;
        Reader(EmissionPoints::Reader rest, const EmissionGuide& map, double most_weight)
            : rest_(rest), most_weight_(most_weight) {
            EmissionPoint uniform;
            for (std::uint32_t s = 0; s < kGuidedDimensions; ++s) uniform[s] = to_unit(rest_(s));
            const EmissionGuide::Image image = map(uniform);
            for (std::size_t s = 0; s < kGuidedDimensions; ++s)
                emission_[s] = to_fraction(image.point[s]);
            weight_ = 1 / image.density;
        }

        EmissionPoints::Reader rest_;
        std::array<std::uint64_t, kGuidedDimensions> emission_{};
        double weight_ = 1;
        double most_weight_;
    };

    Reader path(std::uint32_t number) const { return {points_.path(number), guide_, most_weight_}; }

private:
    EmissionPoints points_;
    const EmissionGuide& guide_;
    double most_weight_;
};

static_assert(PrimarySampleReader<GuidedPoints::Reader>);

}  // namespace sunfleck::engine
