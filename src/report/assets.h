// The files of page/ and the chart library, put into the program by cmake/embed.cmake.
#pragma once

#include <string_view>

namespace sunfleck::engine {

extern const std::string_view kPage;          // page.html
extern const std::string_view kPageStyle;     // page.css
extern const std::string_view kPageScript;    // the .js files, in the order of their names
extern const std::string_view kChartLibrary;  // Chart.js

}  // namespace sunfleck::engine
