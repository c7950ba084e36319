// Several photon paths side by side: all go one step, then all the next.
//
// The steps of different paths do not wait for each other: while a triangle that one path met is
// on its way from memory, other rays are traced. Which paths stand side by side depends on their
// numbers alone.
#pragma once

#include "photon/tracer.h"
#include "sampler/path_range.h"

#include <array>
#include <optional>

namespace sunfleck {

/// @param Points  path(number) gives a slot reader.
/// @param Visit   called with each photon and the number of its path.
/// @param Ended   called with the PathEnd of each path.
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
        for (Walk& walk : walks_) start(walk);
        std::uint64_t rays = 0;
        for (std::uint64_t sent = arrive(); sent > 0; sent = arrive()) {
            rays += sent;
            for (Walk& walk : walks_)
                if (walk.read) go_on(walk);
        }
        return rays;
    }

private:
    static constexpr std::size_t kSideBySide = 16;
    static constexpr std::size_t kLate = 3;
    using Reader = decltype(std::declval<const Points&>().path(0));

    struct Walk {
        std::uint32_t number = 0;
        std::optional<Reader> read;  // none: no path here
        PhotonState state;
        Meeting ahead;
        bool arrived = false;  // at `hit`
        Hit hit;
    };

    /// The next path that starts, if one is left.
    void start(Walk& walk) {
        walk.read.reset();
        while (next_ < end_) {
            walk.number = static_cast<std::uint32_t>(next_++);
            walk.read.emplace(points_.path(walk.number));
            walk.state = PhotonState();
            if (tracer_.start(*walk.read, walk.state)) {
                if constexpr (requires { walk.read->weight(); })
                    walk.state.flux *= static_cast<float>(walk.read->weight());
                return;
            }
            ended_(PathEnd::no_light);
            walk.read.reset();
        }
    }

    /// Asks for the next surface of every path, and works out where it is a few paths later: late
    /// enough for its corners to be there, not so late that they are gone again.
    /// @return the number of rays.
    std::uint64_t arrive() {
        std::uint64_t rays = 0;
        for (std::size_t i = 0; i < kSideBySide + kLate; ++i) {
            if (i < kSideBySide && walks_[i].read) {
                walks_[i].ahead = tracer_.send(walks_[i].state);
                ++rays;
            }
            if (i < kLate) continue;
            Walk& late = walks_[i - kLate];
            if (late.read) late.arrived = tracer_.hit_of(late.ahead, late.hit);
        }
        return rays;
    }

    void go_on(Walk& walk) {
        std::optional<PathEnd> end = PathEnd::escaped;
        const auto see = [&](const Photon& photon) { return visit_(photon, walk.number); };
        if (walk.arrived) end = tracer_.go_on(*walk.read, see, walk.hit, walk.state);
        if (!end) return;
        ended_(*end);
        start(walk);
    }

    const PhotonTracer& tracer_;
    const Points& points_;
    const Visit& visit_;
    const Ended& ended_;
    std::size_t next_ = 0;
    std::size_t end_ = 0;
    std::array<Walk, kSideBySide> walks_;
};

}  // namespace sunfleck
