// Uniform points whose emission slots went through a map: each counts one over its density.
//
// In:  a pass, a map fixed before it, the number of a path. Out: a slot reader, and the weight of
// what is read.
#pragma once

#include "guide/emission_guide.h"
#include "random_numbers/emission_points.h"

#include <algorithm>

namespace sunfleck {

class MappedPoints {
public:
    /// @param pass  of a ladder, whose own points these do not share. @param map  must outlive
    /// this.
    MappedPoints(PassId pass, const EmissionMap& map)
        : points_(pass.with_part(PassId::kParts / 2)), map_(map) {}

    class Reader {
    public:
        std::uint64_t operator()(std::uint32_t index) {
            return index < kMappedSlots ? emission_[index] : rest_(index);
        }
        double weight() const { return weight_; }

    private:
        friend class MappedPoints;
        Reader(EmissionPoints::Reader rest, const EmissionMap& map) : rest_(rest) {
            EmissionPoint uniform;
            for (std::uint32_t s = 0; s < kMappedSlots; ++s) uniform[s] = to_unit(rest_(s));
            const EmissionMap::Image image = map(uniform);
            for (std::size_t s = 0; s < kMappedSlots; ++s)
                emission_[s] = to_fraction(image.point[s]);
            weight_ = 1 / image.density;
        }

        EmissionPoints::Reader rest_;
        std::array<std::uint64_t, kMappedSlots> emission_{};
        double weight_ = 1;
    };

    Reader path(std::uint32_t number) const { return {points_.path(number), map_}; }

private:
    EmissionPoints points_;
    const EmissionMap& map_;
};

static_assert(SlotReader<MappedPoints::Reader>);

}  // namespace sunfleck
