// Context of a trace, for the functions that Embree calls back.
#pragma once

#include "geometry/alpha_test.h"
#include "geometry/built.h"
#include "geometry/line.h"

#include <cstdint>
#include <vector>

namespace sunfleck::engine {

struct Query : RTCIntersectContext {
    Line whole;  // the ray in the world, which the alpha test hashes
    Line line;   // the traced part of it
    const std::vector<BuiltInstance>* instances;
    std::uint32_t first_instance;  // Embree's geometry id of instance 0
    double t = 0;                  // of the nearest exactly intersected point so far
    AlphaTest alpha_test = AlphaTest::by_chance;

    /// @param number  Embree's instance id; RTC_INVALID_GEOMETRY_ID gives null.
    const BuiltInstance* instance_of(unsigned number) const {
        if (number == RTC_INVALID_GEOMETRY_ID) return nullptr;
        return &(*instances)[number - first_instance];
    }

    /// @param walked  ray parameter at which the trace begins.
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
