// Series: snapshots of renders by one method over time, for one or more seeds: a folder of
// pictures, each with its statistics file.
#pragma once

#include "compare/metrics.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// One snapshot.
struct Snapshot {
    std::string picture;  // file name
    std::uint64_t passes = 0;
    double seconds = 0;      // render time so far
    double cpu_seconds = 0;  // processor time so far, of all threads; zero if not recorded
};

/// At least one, with ascending passes.
using Snapshots = std::vector<Snapshot>;

/// Lists the snapshots of a folder: every NAME.exr with NAME.json (docs/reference/stats.md) in the
/// folder, or in each of its subfolders, one per seed, sorted by name.
/// @return at least one seed.
/// @throws Error  for a picture without statistics, statistics that cannot be read, a folder
/// without pictures, or pictures both in the folder and in subfolders.
std::vector<Snapshots> read_series(const std::string& folder);

/// Quartiles and median over seeds; NaN without values.
struct Band {
    double low = Metrics::kNone;
    double middle = Metrics::kNone;
    double high = Metrics::kNone;
};

/// Returns the quantiles 1/4, 1/2, 3/4, linear between neighbours (type 7 of Hyndman and Fan). NaN
/// values are left out.
Band band_of(std::vector<double> values);

/// A snapshot with its metrics.
struct SeriesSample {
    Snapshot snapshot;
    Metrics metrics;  // without HDR-FLIP
};

struct SeriesPoint {
    double passes = 0;  // median over seeds, like the next two
    double seconds = 0;
    double cpu_seconds = 0;
    std::array<Band, kMetrics.size()> bands;  // in the order of kMetrics
};

/// Returns one point per number of passes that all seeds have, and one for their ends if these
/// differ; ascending in seconds.
std::vector<SeriesPoint> series_points(const std::vector<std::vector<SeriesSample>>& seeds);

}  // namespace sunfleck::engine
