// Snapshots of a folder, and their quartiles over seeds.
#include "compare/series.h"

#include "core/snapshot_names.h"
#include "core/statistics_file.h"
#include "sunfleck/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

Snapshot read_snapshot(const fs::path& picture) {
    const std::string stats = fs::path(picture).replace_extension(".json").string();
    std::error_code code;
    if (!fs::is_regular_file(stats, code))
        throw Error({picture.string()},
                    "there is no " + fs::path(stats).filename().string() + " beside it",
                    "write both by sunfleck render --snapshots");
    const std::string text = read_statistics_file(stats);
    try {
        const auto json = nlohmann::json::parse(text);
        Snapshot snapshot{picture.string(), json.at("passes").get<std::uint64_t>(),
                          json.at("seconds").at("total").get<double>(),
                          json.value("cpu_seconds", 0.0)};
        if (!(snapshot.seconds > 0))
            throw Error({stats}, "has a render time of zero",
                        "give the statistics of sunfleck render");
        return snapshot;
    } catch (const nlohmann::json::exception&) {
        throw Error({stats}, "is not a statistics file of a render",
                    "write it by sunfleck render --snapshots or --stats");
    }
}

/// A newest picture that has no statistics is a numbered one once more.
bool is_copy(const fs::path& path) {
    std::error_code code;
    return path.filename() == kLatestExr &&
           !fs::exists(fs::path(path).replace_extension(".json"), code);
}

bool is_snapshot_picture(const fs::path& path) {
    return path.extension() == ".exr" && !is_copy(path);
}

Snapshots snapshots_in(const fs::path& folder) {
    std::vector<fs::path> pictures;
    for (const auto& entry : fs::directory_iterator(folder))
        if (is_snapshot_picture(entry.path())) pictures.push_back(entry.path());
    std::sort(pictures.begin(), pictures.end());
    Snapshots found;
    for (const fs::path& picture : pictures) found.push_back(read_snapshot(picture));
    std::stable_sort(found.begin(), found.end(),
                     [](const Snapshot& a, const Snapshot& b) { return a.passes < b.passes; });
    return found;
}

/// The samples of one point, one per seed.
using Column = std::vector<const SeriesSample*>;

Column column_at(const std::vector<std::vector<SeriesSample>>& seeds, std::uint64_t passes) {
    Column column;
    for (const auto& seed : seeds)
        for (const SeriesSample& sample : seed)
            if (sample.snapshot.passes == passes) {
                column.push_back(&sample);
                break;
            }
    return column;
}

double median(const Column& column, double (*value)(const SeriesSample&)) {
    std::vector<double> values;
    for (const SeriesSample* sample : column) values.push_back(value(*sample));
    return band_of(values).middle;
}

SeriesPoint point_of(const Column& column) {
    SeriesPoint point;
    point.passes = median(
        column, [](const SeriesSample& s) { return static_cast<double>(s.snapshot.passes); });
    point.seconds = median(column, [](const SeriesSample& s) { return s.snapshot.seconds; });
    point.cpu_seconds =
        median(column, [](const SeriesSample& s) { return s.snapshot.cpu_seconds; });
    for (std::size_t m = 0; m < kMetrics.size(); ++m) {
        std::vector<double> values;
        for (const SeriesSample* sample : column)
            values.push_back(sample->metrics.*kMetrics[m].value);
        point.bands[m] = band_of(values);
    }
    return point;
}

}  // namespace

std::vector<Snapshots> read_series(const std::string& folder) {
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_directory()) folders.push_back(entry.path());
    std::sort(folders.begin(), folders.end());
    std::vector<Snapshots> seeds;
    for (const fs::path& seed : folders)
        if (Snapshots found = snapshots_in(seed); !found.empty()) seeds.push_back(std::move(found));
    if (Snapshots here = snapshots_in(folder); !here.empty()) {
        if (!seeds.empty())
            throw Error({folder}, "contains pictures, and so do its subfolders",
                        "use one subfolder per seed");
        seeds.push_back(std::move(here));
    }
    if (seeds.empty())
        throw Error({folder}, "contains no .exr", "create it with sunfleck render --snapshots");
    return seeds;
}

Band band_of(std::vector<double> values) {
    std::erase_if(values, [](double value) { return std::isnan(value); });
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        const double place = share * static_cast<double>(values.size() - 1);
        const auto before = static_cast<std::size_t>(place);
        const std::size_t after = std::min(before + 1, values.size() - 1);
        const double rest = place - static_cast<double>(before);
        return values[before] + rest * (values[after] - values[before]);
    };
    return {at(0.25), at(0.5), at(0.75)};
}

std::vector<SeriesPoint> series_points(const std::vector<std::vector<SeriesSample>>& seeds) {
    std::vector<SeriesPoint> points;
    for (const SeriesSample& sample : seeds.front())
        if (const Column column = column_at(seeds, sample.snapshot.passes);
            column.size() == seeds.size())
            points.push_back(point_of(column));
    Column ends;
    for (const auto& seed : seeds) ends.push_back(&seed.back());
    const bool one_end = std::all_of(ends.begin(), ends.end(), [&](const SeriesSample* end) {
        return end->snapshot.passes == ends.front()->snapshot.passes;
    });
    if (!one_end) points.push_back(point_of(ends));
    std::stable_sort(points.begin(), points.end(), [](const SeriesPoint& a, const SeriesPoint& b) {
        return a.seconds < b.seconds;
    });
    return points;
}

}  // namespace sunfleck::engine
