// The context of a trace, for the functions that Embree calls back.
#pragma once

#include "geometry/alpha_test.h"
#include "geometry/built.h"
#include "geometry/line.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

struct Query : RTCIntersectContext {
    Line whole;  // the ray, in the world: the alpha test hashes it
    Line line;   // what is traced of it
    const std::vector<BuiltInstance>* instances;
    std::uint32_t first_instance;  // Embree's number of instance 0
    double t = 0;                  // of the nearest point on an exactly intersected shape so far
    AlphaTest alpha_test = AlphaTest::by_chance;

    /// @param number  Embree's, or RTC_INVALID_GEOMETRY_ID: then null.
    const BuiltInstance* instance_of(unsigned number) const {
        if (number == RTC_INVALID_GEOMETRY_ID) return nullptr;
        return &(*instances)[number - first_instance];
    }

    /// @param walked  where the trace begins on the ray.
    Query(const Line& ray, double walked, const std::vector<BuiltInstance>& all,
          std::uint32_t first)
        : RTCIntersectContext(),
          whole(ray),
          line(ray.from(walked)),
          instances(&all),
          first_instance(first) {
        rtcInitIntersectContext(this);
    }
};

}  // namespace sunfleck::engine
