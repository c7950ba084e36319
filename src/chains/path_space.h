// PathSpace: what Markov chains require of paths: a path from a primary sample, and its height
// (importance function). Photon paths are one such space; tests have others of known measure.
#pragma once

#include "random_numbers/primary_sample.h"

#include <concepts>
#include <vector>

namespace sunfleck::engine {

/// Heights rank paths by proximity to the visible points. Level sets { height >= h } are nested.
inline constexpr int kHeights = 27;
/// The greatest height: visible, V = 1 of the paper.
inline constexpr int kVisible = kHeights - 1;

/// trace:  makes the path of a primary sample in `path` (whatever that contained); counts rays and
/// others in `tally`. Equal numbers give equal paths.
/// height: of a path, 0 to kVisible. It may depend on frozen state of the pass, never on other
/// paths. Both are thread-safe.
template <class S>
concept PathSpace = requires(const S& space, typename S::Path& path, typename S::Tally& tally,
                             IndependentReader& read) {
    requires std::default_initializable<typename S::Path>;
    requires std::default_initializable<typename S::Tally>;
    tally += tally;
    {space.trace(read, path, tally)};
    { space.height(path) } -> std::same_as<int>;
};

/// Receiver of visible paths. make() returns a collector for some of them, called as collect(path,
/// weight); take(collectors) receives collectors in the order of the paths.
template <class S, class Space>
concept PathSink = requires(S& sink, typename S::Collector& collect,
                            const typename Space::Path& path, double weight) {
    { sink.make() } -> std::same_as<typename S::Collector>;
    {collect(path, weight)};
    {sink.take(std::vector<typename S::Collector>())};
};

}  // namespace sunfleck::engine
