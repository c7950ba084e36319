// Comparison: pictures with metrics against their reference, the data of the table and the page.
#pragma once

#include "compare/metrics.h"
#include "compare/series.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// An input of the user: a picture, or a folder with a series (series.h).
struct CompareInput {
    std::string label;
    std::string path;
};

/// Parses LABEL=PATH, or a path alone, whose label is the file name without ending (or the folder
/// name). A text that is the name of a file is not LABEL=PATH.
CompareInput compare_input(const std::string& text);

/// Returns the files of an input: for a series, all pictures and their statistics.
std::vector<std::string> files_of(const CompareInput& input);

struct Compared {
    CompareInput input;
    std::string shown;  // file of the picture
    RgbImage image;
    std::size_t broken = 0;  // count of pixels that are not finite
    Measured measured;       // empty for the reference
    std::size_t seeds = 0;   // of a series; zero for a picture
    std::vector<SeriesPoint> points;
};

struct Comparison {
    Compared reference;
    std::vector<Compared> pictures;  // in the order given; of a series, the last of the first seed
};

/// Reads and measures all inputs.
/// @throws Error  for what cannot be read, different sizes, repeated labels, and a reference that
/// is a folder.
Comparison compare(const CompareInput& reference, const std::vector<CompareInput>& inputs);

/// Returns a table for the terminal: a row per picture, a column per metric, and a line about
/// pixels left out.
std::string comparison_table(const Comparison& comparison);

/// Returns the table and the series as JSON, ending in a new line (docs/guide/compare.md). Missing
/// values are null.
std::string comparison_json(const Comparison& comparison);

}  // namespace sunfleck::engine
