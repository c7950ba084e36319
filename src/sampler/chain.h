// A Markov chain over primary samples: uniform on the set of those whose paths are high enough.
//
// In:  a seed in the set, the set's least height, the scales of mutations. Out: states, each with
// its path. A proposal outside the set is rejected, so the state counts once more.
// Source: Metropolis et al. 1953 for a target of zero and one: paper, section 4.2, eq. 10.
#pragma once

#include "sampler/path_space.h"
#include "sampler/stored_sample.h"

#include <utility>

namespace sunfleck {

template <PathSpace Space>
class Chain {
public:
    using Path = typename Space::Path;
    using Tally = typename Space::Tally;

    /// @param seed  a sample whose path has least_height. @param stream  this chain's own.
    Chain(const Space& space, int least_height, const StoredSample& seed, RandomStream stream,
          Tally& tally)
        : space_(space), least_height_(least_height), stream_(stream), sample_(seed) {
        space_.trace(RepeatingReader(sample_, stream_), path_, tally);
        height_ = space_.height(path_);
    }

    /// Proposes once. @return what follows if it was accepted: then accept() must be called.
    bool propose(const MutationScales& scales, Acceptances& counts, Tally& tally) {
        const auto kind = static_cast<std::size_t>(stream_.next_fraction() >> 63U);
        proposed_sample_.clear();
        space_.trace(MutatingReader(sample_, proposed_sample_, stream_,
                                    LogUniformMove(scales, kind, stream_)),
                     proposed_path_, tally);
        proposed_height_ = space_.height(proposed_path_);
        const bool accepted = proposed_height_ >= least_height_;
        ++counts[kind].proposed;
        if (accepted) ++counts[kind].accepted;
        return accepted;
    }

    /// Moves to what was proposed last.
    void accept() {
        std::swap(sample_, proposed_sample_);
        std::swap(path_, proposed_path_);
        height_ = proposed_height_;
    }

    const StoredSample& sample() const { return sample_; }
    const Path& path() const { return path_; }
    int height() const { return height_; }

private:
    const Space& space_;
    int least_height_;
    RandomStream stream_;
    StoredSample sample_;
    StoredSample proposed_sample_;
    Path path_;
    Path proposed_path_;
    int height_ = 0;
    int proposed_height_ = 0;
};

}  // namespace sunfleck
