// A figure or table of the paper: its cells, and what is made of them.
#pragma once

#include "experiment/chart.h"
#include "experiment/results.h"
#include "experiment/table.h"

#include <functional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A picture of a cell on the page, with what stands below it.
struct ShownPicture {
    std::string file;  // .exr
    std::string name;  // of the .png, without ending
    std::string caption;
};

/// Pictures of one scene side by side; on a page of their own they lie over its reference.
struct PictureRow {
    std::string name;   // of that page, without ending
    std::string scene;  // gives them one exposure
    std::vector<ShownPicture> pictures;
};

/// What the page shows of a figure, in this order.
struct Section {
    std::vector<std::string> findings;  // paragraphs: our figures, in words
    std::vector<Table> tables;
    std::vector<Chart> charts;
    std::vector<PictureRow> rows;
};

struct Figure {
    std::string name;  // as the user writes it: "fig6"
    std::string title;
    std::string claim;                // what the paper says
    std::vector<std::string> scenes;  // those that need a reference
    std::function<std::vector<Cell>(const RunSettings&)> cells;
    std::function<Section(const Results&)> section;
};

/// All of them, in the paper's order.
const std::vector<Figure>& figures();

/// @throws Error naming all figures for a name that none has.
const Figure& figure_named(const std::string& name);

// One a file of figures/.
Figure table1();
Figure fig1();
Figure fig5();
Figure fig6();
Figure fig7();
Figure fig8();
Figure fig9();
Figure fig10();
Figure fig11();
Figure fig12();
Figure fig13();

}  // namespace sunfleck::engine
