// The embedded files of page/, and the chart library; cmake/embed.cmake compiles them into the
// program.
#pragma once

#include <string_view>

namespace sunfleck::engine {

extern const std::string_view kBaseStyle;     // common/base.css: the look of all pages
extern const std::string_view kPage;          // page.html
extern const std::string_view kPageStyle;     // page.css
extern const std::string_view kPageScript;    // the .js files, sorted by name
extern const std::string_view kChartLibrary;  // Chart.js

}  // namespace sunfleck::engine
