// Sums over passes and rounds of a film, in the order of their numbers.
#include "film/disc_areas.h"

#include "math/wavelengths.h"
#include "measurement/radius.h"

namespace sunfleck {
namespace {

/// A round, and those of its passes that a film holds.
struct RoundAreas {
    double mean = 0;  // over all passes of the round
    double held = 0;  // sum over those that the film holds
    double count = 0;
};

/// Goes on to the next round.
RoundAreas next_round(const PassSet& passes, std::uint64_t round, DiscAreaSequence& areas) {
    RoundAreas result;
    const PassRange range = round_range(round);
    for (std::uint64_t p = range.begin; p < range.end; ++p) {
        const double area = areas.next();
        result.mean += area / kRoundPasses;
        if (passes.count_in({p, p + 1}) == 0) continue;
        result.held += area;
        result.count += 1;
    }
    return result;
}

/// Sums over rounds.
struct Sums {
    double passes = 0;
    double held = 0;           // areas of passes
    double means = 0;          // of a pass that of its round
    double means_by_held = 0;  // areas of passes times those of their rounds
    double rounds = 0;         // complete ones, and their areas and squares of these
    double areas = 0;
    double squares = 0;

    void add(const RoundAreas& round) {
        passes += round.count;
        held += round.held;
        means += round.count * round.mean;
        means_by_held += round.mean * round.held;
        if (round.count < kRoundPasses) return;
        rounds += 1;
        areas += round.mean;
        squares += round.mean * round.mean;
    }
};

}  // namespace

std::optional<DiscAreas> disc_areas(const Film& film) {
    if (!film.key().has_discs() || film.rounds() < kBiasRounds) return {};
    const PassSet& passes = film.passes();
    DiscAreaSequence areas(film.key().alpha);
    Sums sums;
    for (std::uint64_t r = 0; round_range(r).begin < passes.ranges().back().end; ++r)
        sums.add(next_round(passes, r, areas));

    DiscAreas result;
    result.rounds = sums.rounds;
    result.mean = sums.areas / sums.rounds;
    result.squares = sums.squares - sums.areas * result.mean;
    result.mean_of_passes = sums.held / sums.passes;
    result.share = sums.means / sums.passes;
    result.divisor = sums.means_by_held - result.share * sums.held;
    // Of a mean over rounds the variance is that of one round over their number.
    const double lever_squared = result.bias_variance() * result.rounds;
    if (!(result.squares > 0 && result.divisor > 0)) return {};
    if (!(lever_squared <= kLargestLever * kLargestLever)) return {};
    return result;
}

}  // namespace sunfleck
