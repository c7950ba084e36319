// Film: exact sums over passes, from which picture and error bars are computed.
//
// In:  PassImages in any order, each once. Out: sums that depend on the set of passes alone.
// The unit is 2^-64, the range of a pixel's sum [-2^63, 2^63). Terms of a PassImage are at most
// 2^47 (core/exact_sum.h), so 2^16 passes fit even if a pixel has such a term in every pass.
//
// Batches of passes are the independent samples of error bars (batches.h; batch means). When a
// batch is complete, its mean luminance y is computed from its exact sums, for each pixel, each
// block and the whole picture. y^2 is added to the sums of squares, rounded down to 2^-64 and at
// most 2^47 (larger terms are clamped, and those of whole batches counted). Until then the RGB sums
// of the batch are stored beside the totals, by groups of passes. With gather discs, the same is
// done for the photons' light, for blocks and the picture.
//
// In the picture, passes of an open batch count as far as the wavelengths of their group are evenly
// spread (pass_groups.h), because other passes may have a wrong colour for lamps with spectral
// lines (docs/method/errors.md). So the sums of the groups of open batches are stored for each AOV.
//
// Passes that depend on earlier ones are not independent: a sequential film (film_key.h) has no
// batches.
#pragma once

#include "film/batches.h"
#include "film/film_sums.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunfleck::engine {

class Film {
public:
    /// @param key  with at least one pixel.
    explicit Film(FilmKey key);
    /// Takes sums that satisfy the rules above, as film_file reads them.
    explicit Film(FilmSums sums) : sums_(std::move(sums)) {}

    /// Adds one pass, and its dropped and saturated counts to the statistics.
    /// @throws Error, and changes nothing, if the film already contains the pass, if size or AOVs
    /// differ from the key, or if the key has discs and the image has no photons apart.
    void add_pass(std::uint32_t number, const PassImage& image);

    /// Adds to the statistic of that name. Zero makes no entry.
    void count(std::string_view name, std::uint64_t events);
    /// Adds a real number to the statistic of that name. @param x  finite; clamped to
    /// +-kLargestTerm.
    void sum(std::string_view name, double x);
    /// Returns a statistic; zero if nothing was added.
    double statistic(std::string_view name) const;

    /// Adds another film of the same render. The order of merging has no effect on the result.
    /// @param other_name  its source, for the Error.
    /// @throws Error, and changes nothing, if the keys differ, if both have a common pass, or if
    /// passes are sequential.
    void merge(const Film& other, const std::string& other_name);

    const FilmKey& key() const { return sums_.key; }
    const FilmSums& sums() const& { return sums_; }
    FilmSums sums() && { return std::move(sums_); }
    const PassSet& passes() const { return sums_.passes; }
    std::uint64_t pass_count() const { return sums_.passes.count(); }
    /// Returns the number of passes by their weights (pass_weight.h).
    double weight() const;
    /// Returns the complete batches; none for a sequential film.
    CompleteBatches batches() const;
    /// Returns the factor of a pass in the picture: share_of_group(), which is one for complete
    /// whole batches. If no whole batch is complete, it is the number of passes of its batch over
    /// the largest number.
    double share_of_pass(std::uint64_t number) const;
    /// Returns the number of passes in the picture, as the sum over all passes of their weights
    /// times share_of_pass().
    double passes_in_picture() const;

private:
    void add_group(std::uint64_t first, OpenGroup group);
    void close_early_batches(const std::vector<PassRange>& before);
    void join_groups();
    void close_batches();

    FilmSums sums_;
};

/// Calls merge() with a name for films that are not files.
inline void merge(Film& film, const Film& other) {
    film.merge(other, "the other film");
}

}  // namespace sunfleck::engine
