// FilmSums: all data of a film as plain sums, and as a list of arrays in the order of film files.
//
// If gather discs shrink, photons' light is summed apart, by cells of pixels (aovs/pass_image.h):
// once as it is, and once times the disc area of the batch (visible_points/radius.h). From both,
// bias.h computes how the light depends on the area. The second needs no sums of open batches,
// because the factor is the same for all passes of a batch.
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

/// Side of the square blocks for which errors are measured, in pixels.
inline constexpr int kErrorBlock = 8;

using FixedPoints = std::vector<FixedPoint>;

/// Name to sum; names are those of stats.json where it has them.
using FilmStatistics = std::map<std::string, FixedPoint, std::less<>>;

/// Sums of photons' light; all empty if the key has no discs.
struct PhotonSums {
    FixedPoints rgb;            // of each cell, over its pixels and over passes
    FixedPoints rgb_by_area;    // each pass times the disc area of its batch
    FixedPoints block_squares;  // squared luminance of whole batches, row by row of blocks
    FixedPoint image_square;

    friend bool operator==(const PhotonSums&, const PhotonSums&) = default;
};

/// What early batches (batches.h) have more than the sums of whole ones tell. Each of these has
/// as many samples as passes, each the mean of its batch; the other sums have one for a whole
/// batch, and its disc area. All empty unless there are early batches.
struct EarlySums {
    FixedPoints pixel_squares;          // squared luminance of each early batch, times its passes;
                                        // less those of the whole one, once that is complete
    FixedPoints block_squares;          // the same of blocks
    FixedPoints photon_block_squares;   // the same of photons' light
    FixedPoints photon_blocks_by_area;  // photons' luminance of each block, summed over its pixels
                                        // and passes, times the area of its early batch less that
                                        // of the whole one
    FixedPoint image_square;
    FixedPoint photon_image_square;

    friend bool operator==(const EarlySums&, const EarlySums&) = default;
};

/// Sums over the passes of one group of an open batch (pass_groups.h).
struct OpenGroup {
    std::array<FixedPoints, kAovCount> aovs;  // as in FilmSums
    std::vector<FixedPoints> light_groups;
    FixedPoints photon_blocks;  // photons' RGB of each block, summed over its pixels

    friend bool operator==(const OpenGroup&, const OpenGroup&) = default;
};

/// All data of a film; equal sets of passes have equal sums, in whatever order they were added.
struct FilmSums {
    FilmKey key;
    PassSet passes;
    FilmStatistics statistics;
    std::array<FixedPoints, kAovCount> aovs;  // pixel by pixel, channel by channel
    std::vector<FixedPoints> light_groups;    // pixel by pixel, RGB
    FixedPoints pixel_squares;                // squared luminance of complete whole batches
    FixedPoints block_squares;                // row by row of blocks
    FixedPoint image_square;
    PhotonSums photons;
    EarlySums early;
    std::map<std::uint64_t, OpenGroup> open_groups;  // of open batches, by the group's first pass

    friend bool operator==(const FilmSums&, const FilmSums&) = default;
};

/// Returns sums of zero, sized by the key. @param key  with at least one pixel.
FilmSums empty_sums(FilmKey key);

/// Returns whether a film of those passes has sums of early batches.
bool has_early_sums(const FilmKey& key, const PassSet& passes);

/// Returns sums of zero, sized for those passes. @param key  of a film.
EarlySums empty_early_sums(const FilmKey& key, const PassSet& passes);

/// Returns a group without passes.
OpenGroup empty_group(const FilmKey& key);

/// Returns the arrays of totals, without those of open groups and early batches. Some are empty.
std::vector<std::span<FixedPoint>> total_arrays(FilmSums& sums);
std::vector<std::span<const FixedPoint>> total_arrays(const FilmSums& sums);

/// Returns the arrays of early batches. Some are empty.
std::vector<std::span<FixedPoint>> arrays(EarlySums& sums);
std::vector<std::span<const FixedPoint>> arrays(const EarlySums& sums);

/// Returns all arrays: totals, early batches, then the open groups one by one.
std::vector<std::span<FixedPoint>> all_arrays(FilmSums& sums);
std::vector<std::span<const FixedPoint>> all_arrays(const FilmSums& sums);

/// Returns the arrays of an open group. Some are empty.
std::vector<std::span<FixedPoint>> arrays(OpenGroup& group);
std::vector<std::span<const FixedPoint>> arrays(const OpenGroup& group);

}  // namespace sunfleck::engine
