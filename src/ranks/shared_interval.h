// One interval of several ranks: each renders its block, and rank 0 gets the sum.
//
// What is sent: up the tree of ranks.h the films of each part of the interval, merged on the way. A
// part is the whole interval, or its share of a batch where the render may end at any round. Ranks
// without a pass of a part send eight bytes in place of a film.
#pragma once

#include "ranks/ranks.h"
#include "render/pass_maker.h"

#include <functional>

namespace sunfleck {

/// What a rank says at the end of a interval.
struct RankNote {
    double cpu_seconds = 0;
    bool interrupted = false;
};

/// Do all ranks read the same files, by the same program, for the same settings? All call it.
/// @throws Error on each rank that does not agree with rank 0.
void check_same_render(const Ranks& ranks, const FilmKey& key);

class SharedInterval {
public:
    /// @param state  of this rank; its film stays as it is.
    SharedInterval(const RenderJob& job, const Ranks& ranks, RenderState& state)
        : job_(job), ranks_(ranks), passes_(job, state), key_(state.film.key()) {}

    /// All ranks call it with the same interval.
    /// @param note  asked when this rank's block is rendered.
    /// @param take  called on rank 0 with the passes of each part in their order, the film that
    ///              holds them, and the last one's radius factor.
    /// @return what all ranks say: their time summed, and whether any was interrupted; whole on
    ///         rank 0 alone.
    RankNote render(const PassRange& interval, const std::function<RankNote()>& note,
                    const std::function<void(const PassRange&, const Film&, double)>& take);

private:
    const RenderJob& job_;
    const Ranks& ranks_;
    PassMaker passes_;
    FilmKey key_;
};

}  // namespace sunfleck
