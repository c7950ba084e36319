// A series of renders of one method over time, perhaps of several seeds: a folder of pictures, each
// with the stats file of its render beside it.
#pragma once

#include "compare/metrics.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// One picture on the way.
struct Snapshot {
    std::string picture;  // file
    std::uint64_t passes = 0;
    double seconds = 0;      // of the render up to here
    double cpu_seconds = 0;  // the same of all processors together; zero where not recorded
};

/// At least one, passes ascending.
using Snapshots = std::vector<Snapshot>;

/// Reads which snapshots there are: every NAME.exr with NAME.json (docs/reference/stats.md) in the
/// folder, or in each of its subfolders, one a seed, in the order of their names.
/// @return at least one seed.
/// @throws Error for a picture without stats, stats that cannot be read, a folder without pictures,
///         or pictures both in the folder and in subfolders.
std::vector<Snapshots> read_series(const std::string& folder);

/// Quartiles and median over seeds; NaN where nothing has a value.
struct Band {
    double low = Metrics::kNone;
    double middle = Metrics::kNone;
    double high = Metrics::kNone;
};

/// Values at 1/4, 1/2, 3/4 of the sorted ones, linear between neighbours (Hyndman and Fan's type
/// 7). NaN are left out.
Band band_of(std::vector<double> values);

/// A snapshot and how far it is from the reference.
struct SeriesSample {
    Snapshot snapshot;
    Metrics metrics;  // without HDR-FLIP
};

struct SeriesPoint {
    double passes = 0;  // the median over seeds, as the next two
    double seconds = 0;
    double cpu_seconds = 0;
    std::array<Band, kMetrics.size()> bands;  // as kMetrics
};

/// One point for each number of passes that all seeds have, and one for where each ended if that
/// differs. Ascending in seconds.
std::vector<SeriesPoint> series_points(const std::vector<std::vector<SeriesSample>>& seeds);

}  // namespace sunfleck::engine
