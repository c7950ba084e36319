// The film: exact sums over passes, from which picture and error bars are computed.
//
// In:  PassImages, in any order, each once. Out: sums that depend on the set of passes alone.
// Unit 2^-64; range of a pixel's sum [-2^63, 2^63): a PassImage's terms are at most 2^47 each
// (core/exact_sum.h), so 2^16 passes fit even if a term that large hits one pixel in every pass;
// fewer, if they count more than once.
//
// Batches of kBatchPasses passes are the independent samples of error bars. When a batch is
// complete its mean luminance y is computed from its exact sums, of each pixel, each block and the
// whole picture, and w y^2 is added to the sums of squares, w being how often its passes count:
// floored to 2^-64, at most 2^47 (beyond: cut and counted). Until then the batch's own RGB sums are
// kept beside the totals, by groups of passes. The same is done for the luminance that photons have
// brought, of blocks and the picture, where there are discs.
//
// In the picture passes of an open batch count as far as the wavelengths of their group are spread
// evenly (pass_groups.h): where lamps have lines the light of other passes may be off as a whole
// (docs/method/method.md). So the sums of the groups of open batches are kept for each AOV.
//
// Passes that build on those before are no samples: a sequential film (film_key.h) has no batches.
#pragma once

#include "film/film_sums.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunfleck::engine {

class Film {
public:
    /// @param key  at least one pixel.
    explicit Film(FilmKey key);
    /// Sums that keep the rules above, as film_file reads them.
    explicit Film(FilmSums sums) : sums_(std::move(sums)) {}

    /// Adds one pass, and its dropped and saturated counts to the statistics.
    /// @param weight  how often it counts: 1 to kMostWeight, the same for all passes of a batch.
    /// @throws Error, and changes nothing, if the film holds it already, or other passes of its
    ///         batch that count unlike, its size or AOVs are other than the key's, or it does not
    ///         hold photons apart and the key has discs.
    void add_pass(std::uint32_t number, const PassImage& image, std::uint32_t weight = 1);

    /// Adds to the statistic of that name. Zero makes no entry.
    void count(std::string_view name, std::uint64_t events);
    /// The same for a real number. @param x  finite; cut at +-kLargestTerm.
    void sum(std::string_view name, double x);
    /// Value of a statistic; zero if nothing was added.
    double statistic(std::string_view name) const;

    /// Adds another film of the same render. The result does not depend on the order of merging.
    /// @param other_name  where it came from, for the Error.
    /// @throws Error, and changes nothing, if the keys differ, both hold one pass, passes of a
    ///         batch would count unlike, or passes are sequential.
    void merge(const Film& other, const std::string& other_name);

    const FilmKey& key() const { return sums_.key; }
    const FilmSums& sums() const& { return sums_; }
    FilmSums sums() && { return std::move(sums_); }
    const PassSet& passes() const { return sums_.passes; }
    std::uint64_t pass_count() const { return sums_.passes.count(); }
    /// How often all passes count together: sums over passes have so many terms.
    double weight() const;
    /// Complete batches; none of a sequential film.
    std::uint64_t batches() const;
    /// How often these count together, each as its passes.
    double weight_of_batches() const;
    /// How often the passes of complete batches count together.
    double complete_weight() const;
    std::uint32_t weight_of_batch(std::uint64_t batch) const;
    /// Factor on a pass's weight in the picture: share_of_group(); one of complete batches. Where
    /// no batch is complete, the passes that are there of its batch over the most of any.
    double share_of_pass(std::uint64_t number) const;
    /// How often all passes count in the picture together.
    double picture_weight() const;

private:
    void add_group(std::uint64_t number, OpenGroup group);
    void join_groups();
    void close_batches();

    FilmSums sums_;
};

/// merge() with the words for films that are no files.
inline void merge(Film& film, const Film& other) {
    film.merge(other, "the other film");
}

/// Passes of a batch.
PassRange batch_range(std::uint64_t batch);

/// Complete batches in a set of passes.
std::uint64_t complete_batches(const PassSet& passes);

/// A batch whose passes do not all count alike, if there is one. @param heavy  of the passes.
std::optional<std::uint64_t> uneven_batch(const PassSet& passes, const HeavyPasses& heavy);

}  // namespace sunfleck::engine
