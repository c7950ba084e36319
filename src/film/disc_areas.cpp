// Sums over passes and batches of a film, in ascending order.
#include "film/disc_areas.h"

#include "film/pass_weight.h"
#include "math/wavelengths.h"
#include "visible_points/radius.h"

#include <vector>

namespace sunfleck::engine {
namespace {

/// A whole batch, with sums over its passes in the film, by weight.
struct BatchAreas {
    double mean = 0;  // over all passes of the batch
    double held = 0;  // sum over its passes in the film
    double passes = 0;
    double shown = 0;  // passes and sum with the shares of passes in the picture
    double shown_areas = 0;
};

/// Advances to the next batch.
BatchAreas next_batch(const Film& film, std::uint64_t batch, DiscAreaSequence& areas) {
    BatchAreas result;
    const PassRange range = batch_range(batch);
    const double passes_of_whole = weight_in(film.key(), range);
    for (std::uint64_t p = range.begin; p < range.end; ++p) {
        const double weight = weight_of(film.key(), p);
        const double area = areas.next();
        result.mean += weight * area / passes_of_whole;
        if (film.passes().count_in({p, p + 1}) == 0) continue;
        const double share = weight * film.share_of_pass(p);
        result.held += weight * area;
        result.passes += weight;
        result.shown += share;
        result.shown_areas += share * area;
    }
    return result;
}

/// Sums over batches.
struct Sums {
    double passes = 0;
    double held = 0;   // areas of passes
    double shown = 0;  // passes and their areas, with their shares in the picture
    double shown_areas = 0;
    double means = 0;          // for each pass, the mean of its whole batch
    double means_by_held = 0;  // areas of passes times those of their whole batches
    double areas = 0;          // of complete batches, for each pass: areas, and their squares
    double squares = 0;

    void add(const BatchAreas& batch) {
        passes += batch.passes;
        held += batch.held;
        shown += batch.shown;
        shown_areas += batch.shown_areas;
        means += batch.passes * batch.mean;
        means_by_held += batch.mean * batch.held;
    }

    void add_complete(double area, double of_passes) {
        areas += of_passes * area;
        squares += of_passes * area * area;
    }
};

}  // namespace

std::optional<DiscAreas> disc_areas(const Film& film) {
    DiscAreas result{.complete = film.batches()};
    if (!film.key().has_discs() || result.complete.count < kBiasBatches) return {};
    DiscAreaSequence areas(film.key().alpha);
    Sums sums;
    const std::vector<PassRange> early = early_batches(film.passes());
    for (const PassRange& range : early)
        sums.add_complete(area_of(film.key(), range), weight_in(film.key(), range));
    for (std::uint64_t batch = 0; batch_range(batch).begin < film.passes().ranges().back().end;
         ++batch) {
        const BatchAreas next = next_batch(film, batch, areas);
        sums.add(next);
        const bool is_parted = batch == 0 && !early.empty();
        const bool is_complete = film.passes().count_in(batch_range(batch)) == kBatchPasses;
        if (is_complete && !is_parted) sums.add_complete(next.mean, next.passes);
    }
    result.mean = sums.areas / result.complete.passes;
    result.squares = sums.squares - sums.areas * result.mean;
    result.mean_of_passes = sums.shown_areas / sums.shown;
    result.share = sums.means / sums.passes;
    const bool are_whole = !has_early_batches(film.passes());
    if (are_whole) result.divisor = sums.means_by_held - result.share * sums.held;
    // The variance of a mean is that of a pass over their number.
    const double lever_squared = result.bias_variance() * result.complete.passes;
    if (!(result.squares > 0) || (are_whole && !(result.divisor > 0))) return {};
    if (!(lever_squared <= kLargestLever * kLargestLever)) return {};
    return result;
}

}  // namespace sunfleck::engine
