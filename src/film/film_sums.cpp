// Sizes and order of a film's arrays.
#include "film/film_sums.h"

#include "film/luminance.h"

#include <utility>

namespace sunfleck {
namespace {

/// Those of all passes or of an open round.
template <class Sum, class Sums>
std::vector<std::span<Sum>> light_sums(Sums& sums) {
    std::vector<std::span<Sum>> all(sums.layers.begin(), sums.layers.end());
    all.insert(all.end(), sums.light_layers.begin(), sums.light_layers.end());
    return all;
}

template <class Sum, class Round>
std::vector<std::span<Sum>> of_round(Round& round) {
    std::vector<std::span<Sum>> all = light_sums<Sum>(round);
    all.push_back(round.photon_blocks);
    return all;
}

template <class Sum, class Sums>
std::vector<std::span<Sum>> totals(Sums& sums) {
    std::vector<std::span<Sum>> all = light_sums<Sum>(sums);
    auto& photons = sums.photons;
    all.insert(all.end(), {sums.pixel_squares, sums.block_squares, {&sums.image_square, 1}});
    all.insert(all.end(), {photons.rgb, photons.rgb_by_area, photons.block_squares});
    if (sums.key.has_discs()) all.push_back({&photons.image_square, 1});
    return all;
}

template <class Sum, class Sums>
std::vector<std::span<Sum>> everything(Sums& sums) {
    std::vector<std::span<Sum>> all = totals<Sum>(sums);
    for (auto& [number, round] : sums.open_rounds)
        for (const auto& array : of_round<Sum>(round)) all.push_back(array);
    return all;
}

/// Room for the layers that the key has.
template <class Sums>
void make_room(const FilmKey& key, Sums& sums) {
    for (std::size_t i = 0; i < kLayerCount; ++i)
        if (key.has(i)) sums.layers.at(i).resize(key.pixels() * kLayers.at(i).channels.size());
    sums.light_layers.assign(key.light_layers.size(), FixedPoints(3 * key.pixels()));
}

}  // namespace

FilmSums empty_sums(FilmKey key) {
    key.layers[0] = true;
    FilmSums sums;
    const std::size_t pixels = key.pixels();
    const std::size_t blocks = BlockGrid(key, kErrorBlock).count();
    make_room(key, sums);
    sums.pixel_squares.resize(pixels);
    sums.block_squares.resize(blocks);
    if (key.has_discs()) {
        sums.photons.rgb.resize(3 * pixels);
        sums.photons.rgb_by_area.resize(3 * pixels);
        sums.photons.block_squares.resize(blocks);
    }
    sums.key = std::move(key);
    return sums;
}

OpenRound empty_round(const FilmKey& key) {
    OpenRound round;
    make_room(key, round);
    if (key.has_discs()) round.photon_blocks.resize(3 * BlockGrid(key, kErrorBlock).count());
    return round;
}

std::vector<std::span<FixedPoint>> arrays(OpenRound& round) {
    return of_round<FixedPoint>(round);
}

std::vector<std::span<const FixedPoint>> arrays(const OpenRound& round) {
    return of_round<const FixedPoint>(round);
}

std::vector<std::span<FixedPoint>> total_arrays(FilmSums& sums) {
    return totals<FixedPoint>(sums);
}

std::vector<std::span<const FixedPoint>> total_arrays(const FilmSums& sums) {
    return totals<const FixedPoint>(sums);
}

std::vector<std::span<FixedPoint>> all_arrays(FilmSums& sums) {
    return everything<FixedPoint>(sums);
}

std::vector<std::span<const FixedPoint>> all_arrays(const FilmSums& sums) {
    return everything<const FixedPoint>(sums);
}

}  // namespace sunfleck
