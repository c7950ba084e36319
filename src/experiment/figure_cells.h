// The cells that figures need, references included.
#pragma once

#include "experiment/figure.h"

#include <vector>

namespace sunfleck::engine {

/// Cells of a figure and references of its scenes, in the order of rendering.
std::vector<Cell> cells_of(const Figure& figure, const RunSettings& settings);

/// The same of several figures, each cell once.
std::vector<Cell> cells_of(const std::vector<Figure>& figures, const RunSettings& settings);

}  // namespace sunfleck::engine
