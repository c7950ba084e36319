// Sums over passes and rounds of a film, in the order of their numbers.
#include "film/disc_areas.h"

#include "math/wavelengths.h"
#include "visible_points/radius.h"

namespace sunfleck {
namespace {

/// A round, and those of its passes that a film holds.
struct RoundAreas {
    double mean = 0;  // over all passes of the round
    double held = 0;  // sum over those that the film holds
    double count = 0;
    double shown = 0;  // these two as far as passes count in the picture
    double shown_areas = 0;
    double weight = 1;  // how often each counts
};

/// Goes on to the next round.
RoundAreas next_round(const Film& film, std::uint64_t round, DiscAreaSequence& areas) {
    RoundAreas result;
    result.weight = film.weight_of_round(round);
    const PassRange range = round_range(round);
    for (std::uint64_t p = range.begin; p < range.end; ++p) {
        const double area = areas.next();
        result.mean += area / kRoundPasses;
        if (film.passes().count_in({p, p + 1}) == 0) continue;
        const double share = film.share_of_pass(p);
        result.held += area;
        result.count += 1;
        result.shown += share;
        result.shown_areas += share * area;
    }
    return result;
}

/// Sums over rounds.
struct Sums {
    double passes = 0;
    double held = 0;   // areas of passes
    double shown = 0;  // passes, and their areas, as they count in the picture
    double shown_areas = 0;
    double means = 0;          // of a pass that of its round
    double means_by_held = 0;  // areas of passes times those of their rounds
    double rounds = 0;         // complete ones; how often they count, their areas and squares
    double weight = 0;
    double areas = 0;
    double squares = 0;

    void add(const RoundAreas& round) {
        passes += round.weight * round.count;
        held += round.weight * round.held;
        shown += round.weight * round.shown;
        shown_areas += round.weight * round.shown_areas;
        means += round.weight * round.count * round.mean;
        means_by_held += round.weight * round.mean * round.held;
        if (round.count < kRoundPasses) return;
        rounds += 1;
        weight += round.weight;
        areas += round.weight * round.mean;
        squares += round.weight * round.mean * round.mean;
    }
};

}  // namespace

std::optional<DiscAreas> disc_areas(const Film& film) {
    if (!film.key().has_discs() || film.rounds() < kBiasRounds) return {};
    DiscAreaSequence areas(film.key().alpha);
    Sums sums;
    for (std::uint64_t r = 0; round_range(r).begin < film.passes().ranges().back().end; ++r)
        sums.add(next_round(film, r, areas));

    DiscAreas result;
    result.rounds = sums.rounds;
    result.weight = sums.weight;
    result.mean = sums.areas / sums.weight;
    result.squares = sums.squares - sums.areas * result.mean;
    result.mean_of_passes = sums.shown_areas / sums.shown;
    result.share = sums.means / sums.passes;
    result.divisor = sums.means_by_held - result.share * sums.held;
    // Of a mean over rounds the variance is that of a round that counts once over their weight.
    const double lever_squared = result.bias_variance() * result.weight;
    if (!(result.squares > 0 && result.divisor > 0)) return {};
    if (!(lever_squared <= kLargestLever * kLargestLever)) return {};
    return result;
}

}  // namespace sunfleck
