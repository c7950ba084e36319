// A Markov chain over primary samples: uniform on the set of those whose paths are high enough, or
// less often where others sample, too.
//
// In:  a survivor in the set, the set's least height, the scales of mutations. Out: states, each
// with its path. A proposal outside the set is rejected, so the state counts once more. Source:
// Metropolis et al. 1953 for a target of zero and one: paper, section 4.2, eq. 10.
#pragma once

#include "chains/path_space.h"
#include "chains/stored_sample.h"
#include "chains/target.h"

#include <utility>

namespace sunfleck::engine {

template <PathSpace Space>
class Chain {
public:
    using Path = typename Space::Path;
    using Tally = typename Space::Tally;

    /// @param survivor  a sample whose path has the target's height. @param stream  this chain's
    /// own.
    Chain(const Space& space, const Target& target, StoredSample survivor, RandomStream stream,
          Tally& tally)
        : space_(space), target_(target), stream_(stream), sample_(std::move(survivor)) {
        space_.trace(RepeatingReader(sample_, stream_), path_, tally);
        height_ = space_.height(path_);
        is_covered_ = target_.cover.contains(sample_);
    }

    /// Proposes once. @return what follows if it was accepted: then accept() must be called.
    bool propose(const MutationScales& scales, Acceptances& counts, Tally& tally) {
        const auto kind = static_cast<std::size_t>(stream_.next_word() >> 31U);
        proposed_sample_.clear();
        space_.trace(MutatingReader(sample_, proposed_sample_, stream_,
                                    LogUniformMove(scales, kind, stream_)),
                     proposed_path_, tally);
        proposed_height_ = space_.height(proposed_path_);
        const bool accepted = proposed_height_ >= target_.height && is_important();
        ++counts[kind].proposed;
        if (accepted) ++counts[kind].accepted;
        return accepted;
    }

    /// Moves to what was proposed last.
    void accept() {
        std::swap(sample_, proposed_sample_);
        std::swap(path_, proposed_path_);
        height_ = proposed_height_;
        is_covered_ = proposed_is_covered_;
    }

    const StoredSample& sample() const { return sample_; }
    const Path& path() const { return path_; }
    int height() const { return height_; }
    bool is_covered() const { return is_covered_; }

private:
    /// A step onto what is covered is accepted as seldom as that is important.
    bool is_important() {
        proposed_is_covered_ = target_.cover.contains(proposed_sample_);
        return is_covered_ || !proposed_is_covered_ || stream_.next() < target_.cover.importance;
    }

    const Space& space_;
    Target target_;
    RandomStream stream_;
    StoredSample sample_;
    StoredSample proposed_sample_;
    Path path_;
    Path proposed_path_;
    int height_ = 0;
    int proposed_height_ = 0;
    bool is_covered_ = false;
    bool proposed_is_covered_ = false;
};

}  // namespace sunfleck::engine
