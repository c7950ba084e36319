// The loop over figures and cells.
#include "experiment/run.h"

#include "experiment/figure_cells.h"
#include "experiment/page.h"

namespace sunfleck::engine {

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
        for (const Cell& cell : cells_of(figure, store.settings())) {
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

}  // namespace sunfleck::engine
