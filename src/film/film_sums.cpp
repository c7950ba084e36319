// Sizes and order of a film's arrays.
#include "film/film_sums.h"

#include "film/batches.h"
#include "film/luminance.h"

#include <utility>

namespace sunfleck::engine {
namespace {

/// Returns the arrays of light of all passes or of an open group.
template <class Sum, class Sums>
std::vector<std::span<Sum>> light_sums(Sums& sums) {
    std::vector<std::span<Sum>> all(sums.aovs.begin(), sums.aovs.end());
    all.insert(all.end(), sums.light_groups.begin(), sums.light_groups.end());
    return all;
}

template <class Sum, class Group>
std::vector<std::span<Sum>> of_group(Group& group) {
    std::vector<std::span<Sum>> all = light_sums<Sum>(group);
    all.push_back(group.photon_blocks);
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

template <class Sum, class Early>
std::vector<std::span<Sum>> of_early(Early& sums) {
    if (sums.pixel_squares.empty()) return {};
    std::vector<std::span<Sum>> all = {sums.pixel_squares, sums.block_squares};
    all.insert(all.end(), {sums.photon_block_squares, sums.photon_blocks_by_area});
    all.insert(all.end(), {{&sums.image_square, 1}, {&sums.photon_image_square, 1}});
    return all;
}

template <class Sum, class Sums>
std::vector<std::span<Sum>> everything(Sums& sums) {
    std::vector<std::span<Sum>> all = totals<Sum>(sums);
    for (const auto& array : of_early<Sum>(sums.early)) all.push_back(array);
    for (auto& [first, group] : sums.open_groups)
        for (const auto& array : of_group<Sum>(group)) all.push_back(array);
    return all;
}

/// Sizes the AOVs that the key has.
template <class Sums>
void make_room(const FilmKey& key, Sums& sums) {
    for (std::size_t i = 0; i < kAovCount; ++i)
        if (key.has(i)) sums.aovs.at(i).resize(key.pixels() * kAovs.at(i).channels.size());
    sums.light_groups.assign(key.light_groups.size(), FixedPoints(3 * key.pixels()));
}

}  // namespace

FilmSums empty_sums(FilmKey key) {
    key.aovs[0] = true;
    FilmSums sums;
    const std::size_t pixels = key.pixels();
    const std::size_t blocks = blocks_of(key, kErrorBlock).count();
    make_room(key, sums);
    sums.pixel_squares.resize(pixels);
    sums.block_squares.resize(blocks);
    if (key.has_discs()) {
        const std::size_t cells = photon_cells_of(key).count();
        sums.photons.rgb.resize(3 * cells);
        sums.photons.rgb_by_area.resize(3 * cells);
        sums.photons.block_squares.resize(blocks);
    }
    sums.key = std::move(key);
    return sums;
}

bool has_early_sums(const FilmKey& key, const PassSet& passes) {
    return !key.sequential && has_early_batches(passes);
}

EarlySums empty_early_sums(const FilmKey& key, const PassSet& passes) {
    EarlySums sums;
    if (!has_early_sums(key, passes)) return sums;
    const std::size_t blocks = blocks_of(key, kErrorBlock).count();
    sums.pixel_squares.resize(key.pixels());
    sums.block_squares.resize(blocks);
    if (!key.has_discs()) return sums;
    sums.photon_block_squares.resize(blocks);
    sums.photon_blocks_by_area.resize(blocks);
    return sums;
}

OpenGroup empty_group(const FilmKey& key) {
    OpenGroup group;
    make_room(key, group);
    if (key.has_discs()) group.photon_blocks.resize(3 * blocks_of(key, kErrorBlock).count());
    return group;
}

std::vector<std::span<FixedPoint>> arrays(OpenGroup& group) {
    return of_group<FixedPoint>(group);
}

std::vector<std::span<const FixedPoint>> arrays(const OpenGroup& group) {
    return of_group<const FixedPoint>(group);
}

std::vector<std::span<FixedPoint>> arrays(EarlySums& sums) {
    return of_early<FixedPoint>(sums);
}

std::vector<std::span<const FixedPoint>> arrays(const EarlySums& sums) {
    return of_early<const FixedPoint>(sums);
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

}  // namespace sunfleck::engine
