// Pictures beside their reference, measured: all that the table and the page show.
#pragma once

#include "compare/metrics.h"
#include "compare/series.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// What the user names: a picture, or a folder that is a series (series.h).
struct CompareInput {
    std::string label;
    std::string path;
};

/// Reads LABEL=PATH, or a path alone, which is called by its file's name without ending (by its own
/// for a folder). A name that is a file as it stands is no LABEL=PATH.
CompareInput compare_input(const std::string& text);

/// The files that it stands for: of a series, all pictures and their statistics.
std::vector<std::string> files_of(const CompareInput& input);

struct Compared {
    CompareInput input;
    std::string shown;  // the picture's file
    RgbImage image;
    std::size_t broken = 0;  // pixels that are not finite
    Measured measured;       // not of the reference
    std::size_t seeds = 0;   // of a series; zero for a picture
    std::vector<SeriesPoint> points;
};

struct Comparison {
    Compared reference;
    std::vector<Compared> pictures;  // in the order given; of a series, the first seed's last
};

/// Reads and measures all.
/// @throws Error for what cannot be read, sizes that differ, labels that are given twice, a
///         reference that is a folder.
Comparison compare(const CompareInput& reference, const std::vector<CompareInput>& inputs);

/// The table as text for a terminal: a row for each picture, a column for each metric, and a line
/// for what was left out.
std::string comparison_table(const Comparison& comparison);

/// The same and the series as JSON, ending in a new line (docs/guide/compare.md). What has no value
/// is null.
std::string comparison_json(const Comparison& comparison);

}  // namespace sunfleck::engine
