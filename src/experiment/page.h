// What a run leaves: index.html with tables, charts and pictures, each table as CSV, each chart as
// SVG, each row of pictures as a page over its reference, and results.json with all of it and every
// cell.
#pragma once

#include "experiment/finished_figure.h"

#include <vector>

namespace sunfleck::engine {

/// Makes what the page shows of a figure, and writes its tables, charts and rows of pictures to the
/// folder of the run: once, however often the page is written.
FinishedFigure finish_figure(const Results& results, const Figure& figure);

/// Writes index.html and results.json of the figures so far.
void write_results(const Results& results, const std::vector<FinishedFigure>& finished);

}  // namespace sunfleck::engine
