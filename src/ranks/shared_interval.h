// One reduction interval: each rank renders its block of passes, and rank 0 gets the sum.
//
// What is sent: up the tree of ranks.h the films of each part of the interval, merged on the way. A
// part is the whole interval, or its share of a batch where the render may end at any batch. Ranks
// without a pass of a part send eight bytes in place of a film.
#pragma once

#include "film/film.h"
#include "film/pass_set.h"
#include "ranks/ranks.h"

#include <cstdint>
#include <functional>
#include <utility>

namespace sunfleck::engine {

/// What a rank says at the end of an interval.
struct RankNote {
    double cpu_seconds = 0;
    bool interrupted = false;
};

/// Do all ranks read the same files, by the same program, for the same settings? All call it.
/// @throws Error on each rank that does not agree with rank 0.
void check_same_render(const Ranks& ranks, const FilmKey& key);

class SharedInterval {
public:
    /// Renders the pass of that number and adds it to a film. @return its radius factor.
    using MakePass = std::function<double(std::uint32_t number, Film& film)>;

    /// @param key   of the films that passes are added to.
    /// @param ends_at_batches  may the render end at any batch? Then each batch is a part.
    SharedInterval(const Ranks& ranks, FilmKey key, bool ends_at_batches, MakePass make_pass)
        : ranks_(ranks),
          key_(std::move(key)),
          ends_at_batches_(ends_at_batches),
          make_pass_(std::move(make_pass)) {}

    /// All ranks call it with the same interval.
    /// @param note  asked when this rank's block is rendered.
    /// @param take  called on rank 0 with the passes of each part in their order, the film that
    ///              holds them, and the last one's radius factor.
    /// @return what all ranks say: their time summed, and whether any was interrupted; whole on
    ///         rank 0 alone.
    RankNote render(const PassRange& interval, const std::function<RankNote()>& note,
                    const std::function<void(const PassRange&, const Film&, double)>& take);

private:
    const Ranks& ranks_;
    FilmKey key_;
    bool ends_at_batches_;
    MakePass make_pass_;
};

}  // namespace sunfleck::engine
