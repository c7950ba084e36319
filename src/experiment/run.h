// A run of experiments: renders what is missing, then writes tables, charts and the page.
#pragma once

#include "experiment/figure.h"

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// What is about to be rendered.
struct RunProgress {
    std::size_t done = 0;  // cells, of
    std::size_t of = 0;
    std::string cell;             // empty: all are done
    double cpu_seconds_left = 0;  // of those that are not; zero when the budget is in passes
};

/// Renders the cells that are missing, and after each figure the page of all figures so far.
/// @param say  before the first cell, with its name empty, and then before each.
/// @throws Error; Interrupted: what was finished is kept.
void run_figures(const CellStore& store, const std::vector<Figure>& figures,
                 const std::atomic<bool>* interrupted,
                 const std::function<void(const RunProgress&)>& say);

}  // namespace sunfleck::engine
