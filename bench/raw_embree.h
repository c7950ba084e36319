// Embree alone: the yardstick of the benchmarks.
//
// In:  a piece of the renderer's work. Out: the rays that it asked Embree for, and how long Embree
// takes for them, in the same order on the very tree, with nothing computed about the hits.
// A program that links this has an rtcIntersect1 and an rtcOccluded1 of its own before Embree's:
// all rays pass there, a nanosecond each, and are kept while record() runs.
#pragma once

#include "geometry/ray.h"

#include <embree3/rtcore.h>

#include <functional>
#include <vector>

namespace sunfleck::engine::bench {

struct RecordedRay {
    Ray ray;
    bool shadow = false;  // asks for occlusion
};

class RawEmbree {
public:
    /// Runs work() on one thread and keeps its rays.
    /// @param work  on one scene, without covers and of triangles alone: nothing else is traced as
    /// it was.
    static RawEmbree record(const std::function<void()>& work);

    std::size_t size() const { return rays_.size(); }

    /// Traces all on the threads that the limit allows. @return how many met something.
    std::size_t trace() const;

private:
    std::size_t trace_block(std::size_t begin, std::size_t end) const;

    RTCScene world_ = nullptr;
    std::vector<RecordedRay> rays_;

    friend struct Recorder;
};

}  // namespace sunfleck::engine::bench
