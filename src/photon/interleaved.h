// InterleavedPaths: several photon paths traced in lockstep, to hide memory latency.
//
// All paths advance one step, then all the next. While the triangle that one path hit is loaded
// from memory, other rays are traced. Which paths run together depends on their indices alone.
#pragma once

#include "photon/tracer.h"
#include "random_numbers/path_range.h"

#include <array>
#include <new>
#include <optional>
#include <vector>

namespace sunfleck::engine {

/// @tparam Points  path(number) returns a primary-sample reader.
/// @tparam Visit   called with each photon and the index of its path.
/// @tparam Ended   called with the PathEnd of each path.
template <class Points, class Visit, class Ended>
class InterleavedPaths {
public:
    InterleavedPaths(const PhotonTracer& tracer, const Points& points, const Visit& visit,
                     const Ended& ended)
        : tracer_(tracer), points_(points), visit_(visit), ended_(ended) {}

    /// Traces all paths of the range. @return the number of rays.
    std::uint64_t trace(const PathRange& range) {
        next_ = range.begin;
        end_ = range.end;
        ready_.clear();
        ready_.reserve(kSideBySide);
        begun_ = 0;
        for (Walk& walk : walks_) start(walk);
        std::uint64_t rays = 0;
        for (std::uint64_t sent = trace_rays(); sent > 0; sent = trace_rays()) {
            rays += sent;
            go_on();
        }
        return rays;
    }

private:
    static constexpr std::size_t kSideBySide = 16;
    static constexpr std::size_t kLate = 3;
    using Reader = decltype(std::declval<const Points&>().path(0));

    struct Walk {
        std::uint32_t number = 0;
        std::optional<Reader> read;  // empty: no path here
        PhotonState state;
        RayHit ahead;
        bool is_hit = false;  // the ray hit something, or may: `hit`
        Hit hit;
        const Lambert* surface = nullptr;  // surface whose event is computed together with others
        ScatteringEvent event;
        std::optional<PathEnd> end;
    };

    /// The start of a path at its light.
    struct Start {
        std::uint32_t number;
        Reader read;
        PhotonState state;
        bool emits = false;

        Start(std::uint32_t path, const Reader& reader) : number(path), read(reader) {}
    };

    /// Prepares the next paths, as many as run together: one computes while another waits.
    void make_ready() {
        ready_.clear();
        begun_ = 0;
        for (; next_ < end_ && ready_.size() < kSideBySide; ++next_) {
            const auto number = static_cast<std::uint32_t>(next_);
            ready_.emplace_back(number, points_.path(number));
        }
        for (Start& ready : ready_) ready.emits = tracer_.start(ready.read, ready.state);
    }

    /// Starts the next path, if one is left.
    void start(Walk& walk) {
        walk.read.reset();
        walk.surface = nullptr;
        walk.end.reset();
        for (;;) {
            if (begun_ == ready_.size()) make_ready();
            if (ready_.empty()) return;
            const Start& next = ready_[begun_++];
            if (next.emits) return begin(next, walk);
            ended_(PathEnd::no_light);
        }
    }

    static void begin(const Start& from, Walk& walk) {
        walk.number = from.number;
        walk.read.emplace(from.read);
        walk.state = from.state;
    }

    /// Traces the next ray of every path, and computes each hit a few paths later: late enough for
    /// its corners to be in the cache, early enough for them to be there still.
    /// @return the number of rays.
    std::uint64_t trace_rays() {
        std::uint64_t rays = 0;
        for (std::size_t i = 0; i < kSideBySide + kLate; ++i) {
            if (i < kSideBySide && walks_[i].read) {
                // Constructed in place, because a copy would wait for partial stores.
                new (&walks_[i].ahead) RayHit(tracer_.send(walks_[i].state));
                ++rays;
            }
            if (i < kLate) continue;
            Walk& late = walks_[i - kLate];
            if (late.read) late.is_hit = tracer_.complete(late.ahead, late.state, late.hit);
        }
        return rays;
    }

    /// Computes one event of every path. The events of the most frequent kind are computed before
    /// any is applied.
    void go_on() {
        for (Walk& walk : walks_)
            if (walk.read) interact(walk);
        for (Walk& walk : walks_)
            if (walk.surface != nullptr)
                walk.event = sample_scattering(*walk.read, *walk.surface, walk.hit, walk.state);
        for (Walk& walk : walks_) {
            if (walk.surface != nullptr)
                walk.end = tracer_.after_event(walk.event, walk.hit, walk.state);
            if (!walk.end) continue;
            ended_(*walk.end);
            start(walk);
        }
    }

    void interact(Walk& walk) {
        walk.surface = nullptr;
        walk.end = PathEnd::escaped;
        if (!walk.is_hit) return;
        const auto visit = [&](const Photon& photon) { visit_(photon, walk.number, *walk.read); };
        const Lambert* surface = tracer_.plain_surface(walk.hit, walk.state);
        if (surface == nullptr) {
            walk.end = tracer_.go_on(*walk.read, visit, walk.hit, walk.state);
            return;
        }
        walk.end = tracer_.visit_photon(visit, walk.hit, walk.state);
        if (!walk.end) walk.surface = surface;
    }

    const PhotonTracer& tracer_;
    const Points& points_;
    const Visit& visit_;
    const Ended& ended_;
    std::size_t next_ = 0;  // index of the next path to prepare
    std::size_t end_ = 0;
    std::vector<Start> ready_;
    std::size_t begun_ = 0;  // index of the next prepared path
    std::array<Walk, kSideBySide> walks_;
};

}  // namespace sunfleck::engine
