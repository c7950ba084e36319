// What a run leaves: index.html with tables, charts and pictures, each table as CSV, each chart as
// SVG, and results.json with all of it and every cell.
#pragma once

#include "experiment/figure.h"

#include <vector>

namespace sunfleck {

struct FinishedFigure {
    const Figure* figure = nullptr;
    Section section;
};

/// Writes all of it to the folder of the run.
void write_results(const Results& results, const std::vector<FinishedFigure>& finished);

}  // namespace sunfleck
