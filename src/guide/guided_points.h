// Uniform points whose emission dimensions went through a guide: each counts one over its density.
//
// In:  a pass, a guide fixed before it, the number of a path. Out: a dimension reader, and the
// weight of what is read.
#pragma once

#include "guide/emission_guide.h"
#include "random_numbers/emission_points.h"

#include <algorithm>

namespace sunfleck::engine {

class GuidedPoints {
public:
    /// @param pass  its own uniform points are others than these. @param map  must outlive this.
    GuidedPoints(PassId pass, const EmissionGuide& map)
        : points_(pass.with_part(PassId::kParts / 2)), guide_(map) {}

    class Reader {
    public:
        std::uint64_t operator()(std::uint32_t index) {
            return index < kGuidedDimensions ? emission_[index] : rest_(index);
        }
        double weight() const { return weight_; }

    private:
        friend class GuidedPoints;
        Reader(EmissionPoints::Reader rest, const EmissionGuide& map) : rest_(rest) {
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
    };

    Reader path(std::uint32_t number) const { return {points_.path(number), guide_}; }

private:
    EmissionPoints points_;
    const EmissionGuide& guide_;
};

static_assert(PrimarySampleReader<GuidedPoints::Reader>);

}  // namespace sunfleck::engine
