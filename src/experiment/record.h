// results.json: everything that the page shows, and every cell, for programs.
#pragma once

#include "experiment/finished_figure.h"

#include <string>
#include <vector>

namespace sunfleck::engine {

/// @return JSON text, ending in a new line (docs/guide/experiments.md).
std::string results_json(const Results& results, const std::vector<FinishedFigure>& finished);

}  // namespace sunfleck::engine
