// A figure whose cells are rendered, with its parts of the page.
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
