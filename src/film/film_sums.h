// All that a film is, as plain sums; and these as a list of arrays, in the order of film files.
//
// What photons have brought is summed apart where their discs shrink from pass to pass: each pass
// once as it is, once times its batch's area (visible_points/radius.h). From both bias.h has how
// the light depends on the area of the discs. The second needs no sums of open batches: the factor
// is that of the batch, complete or not.
//
// A pass that counts w times, as all of its batch do, is in the sums with w times its light, and
// its batch with w times its square.
#pragma once

#include "film/film_key.h"
#include "film/pass_set.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// Errors are also measured for square blocks of that many pixels a side.
inline constexpr int kErrorBlock = 8;

using FixedPoints = std::vector<FixedPoint>;

/// Name to sum; names are those of stats.json where it has them.
using FilmStatistics = std::map<std::string, FixedPoint, std::less<>>;

/// Of light brought by photons; all empty where the key has no discs.
struct PhotonSums {
    FixedPoints rgb;            // of each pixel, over passes
    FixedPoints rgb_by_area;    // the same, each pass times the area of its batch
    FixedPoints block_squares;  // of complete batches' luminance, row after row of blocks
    FixedPoint image_square;

    friend bool operator==(const PhotonSums&, const PhotonSums&) = default;
};

/// Sums over the passes that are there of one group of an open batch (pass_groups.h).
struct OpenGroup {
    std::array<FixedPoints, kAovCount> aovs;  // as in FilmSums
    std::vector<FixedPoints> light_groups;
    FixedPoints photon_blocks;  // RGB of each block, over its pixels: what photons have brought

    friend bool operator==(const OpenGroup&, const OpenGroup&) = default;
};

/// How often a pass may count (planning/budget_allocation.h).
inline constexpr std::uint32_t kMostWeight = 4;

/// Passes that count more than once, by how often.
using HeavyPasses = std::map<std::uint32_t, PassSet>;

/// One set of passes has one value of this, however it was put together.
struct FilmSums {
    FilmKey key;
    PassSet passes;
    HeavyPasses heavy;
    FilmStatistics statistics;
    std::array<FixedPoints, kAovCount> aovs;  // pixel after pixel, channel after channel
    std::vector<FixedPoints> light_groups;    // the same, RGB
    FixedPoints pixel_squares;                // of complete batches' luminance
    FixedPoints block_squares;                // row after row of blocks
    FixedPoint image_square;
    PhotonSums photons;
    std::map<std::uint64_t, OpenGroup> open_groups;  // of open batches, by the group's first number

    friend bool operator==(const FilmSums&, const FilmSums&) = default;
};

/// Sums of no pass, of the sizes that the key asks for. @param key  at least one pixel.
FilmSums empty_sums(FilmKey key);

/// A group with no pass.
OpenGroup empty_group(const FilmKey& key);

/// The arrays that grow with each pass or batch, those of open groups left out. Some are empty.
std::vector<std::span<FixedPoint>> total_arrays(FilmSums& sums);
std::vector<std::span<const FixedPoint>> total_arrays(const FilmSums& sums);

/// These and the open groups', group after group.
std::vector<std::span<FixedPoint>> all_arrays(FilmSums& sums);
std::vector<std::span<const FixedPoint>> all_arrays(const FilmSums& sums);

/// The arrays of an open group. Some are empty.
std::vector<std::span<FixedPoint>> arrays(OpenGroup& group);
std::vector<std::span<const FixedPoint>> arrays(const OpenGroup& group);

}  // namespace sunfleck::engine
