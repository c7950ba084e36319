// Adding passes, folding complete rounds, merging films.
#include "film/film.h"

#include "core/error.h"
#include "core/parallel.h"
#include "film/luminance.h"
#include "math/wavelengths.h"

#include <atomic>
#include <cmath>
#include <utility>

namespace sunfleck {
namespace {

constexpr std::size_t kPixelsPerTask = 1U << 14U;

void add_all(FixedPoints& sums, const FixedPoints& terms) {
    parallel_blocks(sums.size(), kPixelsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) sums[i] += terms[i];
    });
}

void add_layer(FixedPoints& sums, const PassImage& image, const LayerRow& row) {
    const std::size_t channels = row.channels.size();
    parallel_blocks(sums.size(), kPixelsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            sums[i] += image.value(row.layer, i / channels, i % channels);
    });
}

/// The square of a round's luminance as a term of an exact sum.
FixedPoint square_term(double y, std::atomic<std::uint64_t>& saturated) {
    double square = y * y;
    if (!(square <= kLargestTerm)) {
        saturated.fetch_add(1, std::memory_order_relaxed);
        square = kLargestTerm;
    }
    return FixedPoint::from_double(square);
}

/// Adds the squares of a complete round; returns how many were cut.
std::uint64_t add_squares(FilmSums& sums, const FixedPoints& round) {
    const BlockGrid grid(sums.key, kErrorBlock);
    std::vector<double> block_sum(grid.count());  // luminance, over the block's pixels
    std::atomic<std::uint64_t> saturated{0};
    parallel_for(grid.count(), [&](std::size_t b) {
        RgbSum block;
        grid.for_pixels(b, [&](std::size_t pixel) {
            const RgbSum rgb{{round[3 * pixel], round[3 * pixel + 1], round[3 * pixel + 2]}};
            sums.pixel_squares[pixel] += square_term(rgb.mean_luminance(kRoundPasses), saturated);
            block += rgb;
        });
        block_sum[b] = block.mean_luminance(kRoundPasses);
        const auto pixels = static_cast<double>(grid.block(b).pixels());
        sums.block_squares[b] += square_term(block_sum[b] / pixels, saturated);
    });
    double total = 0;
    for (const double y : block_sum) total += y;
    const double mean = total / static_cast<double>(sums.key.pixels());
    sums.image_square += square_term(mean, saturated);
    return saturated.load();
}

void check_image(const FilmKey& key, std::uint32_t number, const PassImage& image) {
    const SourceLocation where{"pass " + std::to_string(number)};
    if (image.pixels() != key.pixels())
        throw Error(where,
                    "has " + std::to_string(image.pixels()) + " pixels, the film " +
                        std::to_string(key.pixels()),
                    "render it at the film's resolution");
    for (std::size_t i = 0; i < kLayerCount; ++i)
        if (key.has(i) && !image.has(kLayers.at(i).layer))
            throw Error(where, "lacks the layer \"" + std::string(kLayers.at(i).name) + "\"",
                        "render it with the film's layers");
}

}  // namespace

PassRange round_range(std::uint64_t round) {
    return {round * kRoundPasses, (round + 1) * kRoundPasses};
}

std::uint64_t complete_rounds(const PassSet& passes) {
    std::uint64_t rounds = 0;
    for (const PassRange& range : passes.ranges()) {
        const std::uint64_t first = (range.begin + kRoundPasses - 1) / kRoundPasses;
        const std::uint64_t end = range.end / kRoundPasses;
        if (end > first) rounds += end - first;
    }
    return rounds;
}

std::vector<std::uint64_t> open_rounds(const PassSet& passes) {
    std::vector<std::uint64_t> open;
    const auto add = [&](std::uint64_t round) {
        const std::uint64_t held = passes.count_in(round_range(round));
        const bool known = !open.empty() && open.back() == round;
        if (held > 0 && held < kRoundPasses && !known) open.push_back(round);
    };
    for (const PassRange& range : passes.ranges()) {
        add(range.begin / kRoundPasses);
        add((range.end - 1) / kRoundPasses);
    }
    return open;
}

Film::Film(FilmKey key) {
    key.layers[0] = true;
    for (std::size_t i = 0; i < kLayerCount; ++i)
        if (key.has(i)) sums_.layers.at(i).resize(key.pixels() * kLayers.at(i).channels.size());
    sums_.pixel_squares.resize(key.pixels());
    sums_.block_squares.resize(BlockGrid(key, kErrorBlock).count());
    sums_.key = std::move(key);
}

std::uint64_t Film::rounds() const {
    return key().sequential ? 0 : complete_rounds(sums_.passes);
}

void Film::count(std::string_view name, std::uint64_t events) {
    if (events == 0) return;
    sums_.statistics[std::string(name)] += FixedPoint{static_cast<std::int64_t>(events), 0};
}

void Film::sum(std::string_view name, double x) {
    const double cut = std::fmin(std::fmax(x, -kLargestTerm), kLargestTerm);
    if (cut != 0) sums_.statistics[std::string(name)] += FixedPoint::from_double(cut);
}

double Film::statistic(std::string_view name) const {
    const auto found = sums_.statistics.find(name);
    return found == sums_.statistics.end() ? 0 : found->second.to_double();
}

void Film::add_pass(std::uint32_t number, const PassImage& image) {
    const PassRange range{number, std::uint64_t{number} + 1};
    if (sums_.passes.count_in(range) != 0)
        throw Error({"pass " + std::to_string(number)}, "the film holds it already",
                    "add each pass once");
    check_image(sums_.key, number, image);
    for (std::size_t i = 0; i < kLayerCount; ++i)
        if (key().has(i)) add_layer(sums_.layers.at(i), image, kLayers.at(i));
    count("dropped_nonfinite", image.dropped());
    count("saturated", image.saturated());
    sums_.passes.insert(range);
    if (key().sequential) return;
    FixedPoints& round = sums_.open_rounds[number / kRoundPasses];
    round.resize(3 * key().pixels());
    add_layer(round, image, kLayers[0]);
    close_rounds();
}

void Film::close_rounds() {
    for (auto round = sums_.open_rounds.begin(); round != sums_.open_rounds.end();) {
        const bool complete = sums_.passes.count_in(round_range(round->first)) == kRoundPasses;
        if (complete) count("saturated_squares", add_squares(sums_, round->second));
        round = complete ? sums_.open_rounds.erase(round) : std::next(round);
    }
}

void Film::merge(const Film& other, const std::string& other_name) {
    const FilmSums& from = other.sums_;
    if (const auto differs = difference(sums_.key, from.key)) {
        const std::string values =
            differs->here.empty() ? "" : ": " + differs->here + " and " + differs->there;
        throw Error({other_name}, "is of another render: " + differs->what + " differs" + values,
                    "merge parts of one render alone");
    }
    if (key().sequential)
        throw Error({other_name}, "its passes build on one another and are no parts of a render",
                    "render with another --photon-sampler to merge");
    for (const PassRange& range : from.passes.ranges())
        if (sums_.passes.count_in(range) != 0)
            throw Error({other_name},
                        "passes " + std::to_string(range.begin) + ":" + std::to_string(range.end) +
                            " are in another part, too, some or all",
                        "give each part passes of its own with --pass-range");
    for (std::size_t i = 0; i < kLayerCount; ++i) add_all(sums_.layers.at(i), from.layers.at(i));
    add_all(sums_.pixel_squares, from.pixel_squares);
    add_all(sums_.block_squares, from.block_squares);
    sums_.image_square += from.image_square;
    for (const auto& [number, sums] : from.open_rounds) {
        FixedPoints& round = sums_.open_rounds[number];
        round.resize(sums.size());
        add_all(round, sums);
    }
    for (const auto& [name, value] : from.statistics) sums_.statistics[name] += value;
    for (const PassRange& range : from.passes.ranges()) sums_.passes.insert(range);
    close_rounds();
}

}  // namespace sunfleck
