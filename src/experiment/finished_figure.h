// A figure whose cells are rendered, with what the page shows of it.
#pragma once

#include "experiment/figure.h"

#include <string>

namespace sunfleck::engine {

struct FinishedFigure {
    const Figure* figure = nullptr;
    Section section;
    std::string html;
};

}  // namespace sunfleck::engine
