// The help of a flag, put together from its row.
#include "flags/flag.h"

namespace sunfleck::engine {

std::string help_text(const RenderFlag& flag) {
    std::string text = flag.help;
    const char* before = flag.value.is_list ? ": " : ". ";
    for (const FlagChoice& choice : flag.value.choices) {
        if (choice.what.empty() && !flag.value.is_list) continue;
        text += before + choice.name + (choice.what.empty() ? "" : ": " + choice.what);
        before = flag.value.is_list ? "," : "; ";
    }
    const std::string range = flag.value.range;
    const std::string standard = flag.standard.empty() ? "" : "default " + flag.standard;
    if (range.empty() && standard.empty()) return text;
    return text + " (" + range + (range.empty() || standard.empty() ? "" : "; ") + standard + ")";
}

}  // namespace sunfleck::engine
