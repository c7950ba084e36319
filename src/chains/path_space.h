// What a Markov chain must know of paths: how to make one from numbers, and how near it comes to
// being seen. Photon paths are one such space; tests have others, of known measure.
#pragma once

#include "random_numbers/primary_sample.h"

#include <concepts>
#include <vector>

namespace sunfleck::engine {

/// Heights rank paths: the higher, the nearer to what is seen. Sets { height >= h } are nested.
inline constexpr int kHeights = 27;
/// The greatest height: visible, V = 1 of the paper.
inline constexpr int kVisible = kHeights - 1;

/// trace:  makes the path of a primary sample in `path` (whatever that held before); counts rays
///         and the like in `tally`. The same numbers give the same path.
/// height: of a path, 0 to kVisible. May look at the pass's frozen state, never at other paths.
/// Both may be called by many threads at once.
template <class S>
concept PathSpace = requires(const S& space, typename S::Path& path, typename S::Tally& tally,
                             IndependentReader& read) {
    requires std::default_initializable<typename S::Path>;
    requires std::default_initializable<typename S::Tally>;
    tally += tally;
    {space.trace(read, path, tally)};
    { space.height(path) } -> std::same_as<int>;
};

/// Where visible paths go. make() gives a collector for some of them, called as
/// collect(path, weight); take(collectors) gets them in the order of the paths.
template <class S, class Space>
concept PathSink = requires(S& sink, typename S::Collector& collect,
                            const typename Space::Path& path, double weight) {
    { sink.make() } -> std::same_as<typename S::Collector>;
    {collect(path, weight)};
    {sink.take(std::vector<typename S::Collector>())};
};

}  // namespace sunfleck::engine
