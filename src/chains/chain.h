// Chain: a Markov chain over primary samples, uniform on a level set, or less dense where guided
// paths sample, too.
//
// In:  a survivor in the set, the least height of the set, mutation scales. Out: states with their
// paths. A proposal outside the set is rejected, so that the state counts once more.
// Source: Metropolis et al. 1953 for a target of zero and one: paper, section 4.2, eq. 10.
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

    /// @param survivor  a sample whose path has the target's height.
    /// @param stream  this chain's own.
    Chain(const Space& space, const Target& target, StoredSample survivor, RandomStream stream,
          Tally& tally)
        : space_(space), target_(target), stream_(stream), sample_(std::move(survivor)) {
        space_.trace(RepeatingReader(sample_, stream_), path_, tally);
        height_ = space_.height(path_);
        share_ = target_.share_of(sample_);
    }

    /// Proposes a mutation. @return the path if it was accepted; the caller then calls accept().
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

    /// Moves to the last proposal.
    void accept() {
        std::swap(sample_, proposed_sample_);
        std::swap(path_, proposed_path_);
        height_ = proposed_height_;
        share_ = proposed_share_;
    }

    const StoredSample& sample() const { return sample_; }
    const Path& path() const { return path_; }
    int height() const { return height_; }
    const ChainShare& share() const { return share_; }

private:
    /// Accepts a step to lower importance with the probability of their ratio.
    bool is_important() {
        proposed_share_ = target_.share_of(proposed_sample_);
        return proposed_share_.importance >= share_.importance ||
               stream_.next() * share_.importance < proposed_share_.importance;
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
    ChainShare share_;
    ChainShare proposed_share_;
};

}  // namespace sunfleck::engine
