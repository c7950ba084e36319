// The cells that figures need, references included.
#pragma once

#include "experiment/figure.h"

#include <vector>

namespace sunfleck::engine {

/// Returns the cells of a figure and the references of its scenes, in rendering order.
std::vector<Cell> cells_of(const Figure& figure, const RunSettings& settings);

/// Returns the cells of several figures, each once.
std::vector<Cell> cells_of(const std::vector<Figure>& figures, const RunSettings& settings);

}  // namespace sunfleck::engine
