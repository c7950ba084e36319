// References first, then the figure's own cells.
#include "experiment/figure_cells.h"

#include "experiment/methods.h"

#include <set>

namespace sunfleck::engine {

std::vector<Cell> cells_of(const Figure& figure, const RunSettings& settings) {
    std::vector<Cell> cells;
    for (const std::string& scene : figure.scenes) cells.push_back(reference_cell(scene, settings));
    for (Cell& cell : figure.cells(settings)) cells.push_back(std::move(cell));
    return cells;
}

std::vector<Cell> cells_of(const std::vector<Figure>& figures, const RunSettings& settings) {
    std::vector<Cell> cells;
    std::set<std::string> seen;
    for (const Figure& figure : figures)
        for (Cell& cell : cells_of(figure, settings))
            if (seen.insert(cell.key()).second) cells.push_back(std::move(cell));
    return cells;
}

}  // namespace sunfleck::engine
