// Sums over passes and batches of a film, in ascending order.
#include "film/disc_areas.h"

#include "math/wavelengths.h"
#include "visible_points/radius.h"

namespace sunfleck::engine {
namespace {

/// A batch, with sums over its passes in the film.
struct BatchAreas {
    double mean = 0;  // over all passes of the batch
    double held = 0;  // sum over its passes in the film
    double count = 0;
    double shown = 0;  // count and sum with the shares of passes in the picture
    double shown_areas = 0;
};

/// Advances to the next batch.
BatchAreas next_batch(const Film& film, std::uint64_t batch, DiscAreaSequence& areas) {
    BatchAreas result;
    const PassRange range = batch_range(batch);
    for (std::uint64_t p = range.begin; p < range.end; ++p) {
        const double area = areas.next();
        result.mean += area / kBatchPasses;
        if (film.passes().count_in({p, p + 1}) == 0) continue;
        const double share = film.share_of_pass(p);
        result.held += area;
        result.count += 1;
        result.shown += share;
        result.shown_areas += share * area;
    }
    return result;
}

/// Sums over batches.
struct Sums {
    double passes = 0;
    double held = 0;   // areas of passes
    double shown = 0;  // count and areas of passes, with their shares in the picture
    double shown_areas = 0;
    double means = 0;          // for each pass, the mean of its batch
    double means_by_held = 0;  // areas of passes times those of their batches
    double batches = 0;        // of complete batches: count, areas, and their squares
    double areas = 0;
    double squares = 0;

    void add(const BatchAreas& batch) {
        passes += batch.count;
        held += batch.held;
        shown += batch.shown;
        shown_areas += batch.shown_areas;
        means += batch.count * batch.mean;
        means_by_held += batch.mean * batch.held;
        if (batch.count < kBatchPasses) return;
        batches += 1;
        areas += batch.mean;
        squares += batch.mean * batch.mean;
    }
};

}  // namespace

std::optional<DiscAreas> disc_areas(const Film& film) {
    if (!film.key().has_discs() || film.batches() < kBiasBatches) return {};
    DiscAreaSequence areas(film.key().alpha);
    Sums sums;
    for (std::uint64_t batch = 0; batch_range(batch).begin < film.passes().ranges().back().end;
         ++batch)
        sums.add(next_batch(film, batch, areas));

    DiscAreas result;
    result.batches = sums.batches;
    result.mean = sums.areas / sums.batches;
    result.squares = sums.squares - sums.areas * result.mean;
    result.mean_of_passes = sums.shown_areas / sums.shown;
    result.share = sums.means / sums.passes;
    result.divisor = sums.means_by_held - result.share * sums.held;
    // The variance of a mean over batches is that of a batch over their number.
    const double lever_squared = result.bias_variance() * result.batches;
    if (!(result.squares > 0 && result.divisor > 0)) return {};
    if (!(lever_squared <= kLargestLever * kLargestLever)) return {};
    return result;
}

}  // namespace sunfleck::engine
