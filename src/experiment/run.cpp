// The loop over figures and cells.
#include "experiment/run.h"

#include "experiment/methods.h"
#include "experiment/page.h"

#include <set>

namespace sunfleck {
namespace {

std::vector<Cell> cells_of_one(const Figure& figure, const RunSettings& settings) {
    std::vector<Cell> cells;
    for (const std::string& scene : figure.scenes) cells.push_back(reference_cell(scene, settings));
    for (Cell& cell : figure.cells(settings)) cells.push_back(std::move(cell));
    return cells;
}

}  // namespace

std::vector<Cell> cells_of(const std::vector<Figure>& figures, const RunSettings& settings) {
    std::vector<Cell> cells;
    std::set<std::string> seen;
    for (const Figure& figure : figures)
        for (Cell& cell : cells_of_one(figure, settings))
            if (seen.insert(cell.key()).second) cells.push_back(std::move(cell));
    return cells;
}

void run_figures(const CellStore& store, const std::vector<Figure>& figures,
                 const std::atomic<bool>* interrupted,
                 const std::function<void(const RunProgress&)>& say) {
    RunProgress progress;
    for (const Cell& cell : cells_of(figures, store.settings())) {
        ++progress.of;
        if (store.has(cell))
            ++progress.done;
        else
            progress.cpu_seconds_left += store.expected_seconds(cell);
    }
    say(progress);
    const Results results(store);
    std::vector<FinishedFigure> finished;
    for (const Figure& figure : figures) {
        for (const Cell& cell : cells_of_one(figure, store.settings())) {
            if (store.has(cell)) continue;
            progress.cell = cell.key();
            say(progress);
            store.run(cell, interrupted);
            ++progress.done;
            progress.cpu_seconds_left -= store.expected_seconds(cell);
        }
        finished.push_back(finish_figure(results, figure));
        write_results(results, finished);
    }
}

}  // namespace sunfleck
