// SharedInterval: one reduction interval, in which each rank renders its block of passes and rank 0
// receives the sum.
//
// Films of each part of the interval go up the tree of ranks.h and are merged on the way. A part is
// the whole interval, or its share of a batch if the render may end at any batch. Ranks without a
// pass of a part send eight bytes in place of a film.
#pragma once

#include "film/film.h"
#include "film/pass_set.h"
#include "ranks/ranks.h"

#include <cstdint>
#include <functional>
#include <utility>

namespace sunfleck::engine {

/// Data that a rank reports at the end of an interval.
struct RankNote {
    double cpu_seconds = 0;
    bool interrupted = false;
};

/// Checks that all ranks have the same files, program and settings; all ranks call it.
/// @throws Error  on each rank that differs from rank 0.
void check_same_render(const Ranks& ranks, const FilmKey& key);

class SharedInterval {
public:
    /// Renders a pass and adds it to a film. @return its radius factor.
    using MakePass = std::function<double(std::uint32_t number, Film& film)>;

    /// @param key   of the films.
    /// @param ends_at_batches  whether the render may end at any batch; then each batch is a part.
    SharedInterval(const Ranks& ranks, FilmKey key, bool ends_at_batches, MakePass make_pass)
        : ranks_(ranks),
          key_(std::move(key)),
          ends_at_batches_(ends_at_batches),
          make_pass_(std::move(make_pass)) {}

    /// Renders an interval; all ranks call it with the same one.
    /// @param note  called when this rank's block is rendered.
    /// @param take  called on rank 0 with the passes of each part in order, their film, and the
    /// last one's radius factor.
    /// @return the reports of all ranks: sum of times, and whether any was interrupted; complete on
    /// rank 0 alone.
    RankNote render(const PassRange& interval, const std::function<RankNote()>& note,
                    const std::function<void(const PassRange&, const Film&, double)>& take);

private:
    const Ranks& ranks_;
    FilmKey key_;
    bool ends_at_batches_;
    MakePass make_pass_;
};

}  // namespace sunfleck::engine
