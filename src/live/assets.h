// The embedded page of page/; cmake/embed.cmake compiles its files into the program.
#pragma once

#include <string_view>

namespace sunfleck::engine {

extern const std::string_view kLivePage;    // page.html
extern const std::string_view kLiveStyle;   // the .css files
extern const std::string_view kLiveScript;  // the .js files

}  // namespace sunfleck::engine
