// Runs an experiment: renders missing cells, then writes tables, charts and the page.
#pragma once

#include "experiment/figure.h"

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// The progress before a render.
struct RunProgress {
    std::size_t done = 0;  // finished cells, of
    std::size_t of = 0;
    std::string cell;             // empty if all are done
    double cpu_seconds_left = 0;  // of unfinished cells; zero if the budget is in passes
};

/// Renders the missing cells, and writes the page of all figures so far after each figure.
/// @param say  called before the first cell, with an empty name, and then before each.
/// @throws Error; Interrupted: finished cells are kept.
void run_figures(const CellStore& store, const std::vector<Figure>& figures,
                 const std::atomic<bool>* interrupted,
                 const std::function<void(const RunProgress&)>& say);

}  // namespace sunfleck::engine
