// The choice of channels, by their names.
#include "image/exr_colours.h"

#include "core/printable.h"
#include "core/small_letters.h"
#include "sunfleck/error.h"

#include <algorithm>
#include <array>
#include <map>

namespace sunfleck::engine {
namespace {

using Names = std::vector<std::string>;

bool has(const Names& all, const std::string& name) {
    return std::find(all.begin(), all.end(), name) != all.end();
}

std::string joined(const Names& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return printable(text, 100);
}

/// 0 red, 1 green, 2 blue, 3 alpha, or 4: none of them. @param name  without its layer.
std::size_t colour_by(const std::string& name) {
    static constexpr std::array<std::array<std::string_view, 2>, 4> kWords = {
        {{"r", "red"}, {"g", "green"}, {"b", "blue"}, {"a", "alpha"}}};
    const std::string small = small_letters(name);
    const auto* const found = std::find_if(kWords.begin(), kWords.end(), [&](const auto& words) {
        return small == words[0] || small == words[1];
    });
    return static_cast<std::size_t>(found - kWords.begin());
}

/// Red, green, blue and perhaps alpha of each layer that has the first three.
std::vector<Names> coloured_layers(const Names& all) {
    std::map<std::string, std::array<std::string, 5>> layers;
    for (const std::string& name : all) {
        const std::size_t dot = name.rfind('.');
        const std::string layer = dot == std::string::npos ? "" : name.substr(0, dot);
        const std::string last = dot == std::string::npos ? name : name.substr(dot + 1);
        layers[layer].at(colour_by(last)) = name;
    }
    std::vector<Names> coloured;
    for (const auto& [layer, colours] : layers) {
        if (colours[0].empty() || colours[1].empty() || colours[2].empty()) continue;
        coloured.push_back({colours[0], colours[1], colours[2]});
        if (!colours[3].empty()) coloured.back().push_back(colours[3]);
    }
    return coloured;
}

}  // namespace

ExrColours exr_colours(const Names& all, const std::string& name) {
    const auto refuse = [&](const std::string& what, const std::string& mend) {
        throw Error({name}, what, mend);
    };
    if (all.empty()) refuse("has no channels", "write the picture again, with channels R, G and B");
    if (has(all, "R") && has(all, "G") && has(all, "B")) {
        if (has(all, "A")) return {{"R", "G", "B", "A"}, false, ""};
        return {{"R", "G", "B"}, false, ""};
    }
    if (has(all, "X") && has(all, "Y") && has(all, "Z"))
        return {{"X", "Y", "Z"}, true, "its channels X, Y and Z are read as colours of CIE XYZ"};
    if (has(all, "RY") || has(all, "BY"))
        refuse("has luminance and chroma (Y, RY, BY), which are not read",
               "convert it to channels R, G and B");
    const std::vector<Names> coloured = coloured_layers(all);
    if (coloured.size() == 1)
        return {coloured[0], false, "its channels " + joined(coloured[0]) + " are its colours"};
    if (coloured.size() > 1)
        refuse("has no channels R, G and B, but " + std::to_string(coloured.size()) +
                   " layers of colours: " + joined(all),
               "write one of them alone, as R, G and B");
    if (has(all, "Y")) return {{"Y"}, false, ""};
    if (all.size() > 1)
        refuse("has no channels R, G and B, but " + joined(all),
               "write the picture again, with channels R, G and B");
    return {all, false, ""};
}

}  // namespace sunfleck::engine
