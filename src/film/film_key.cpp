// Comparison of film keys, field by field, with text for the user.
#include "film/film_key.h"

#include <algorithm>
#include <sstream>

namespace sunfleck::engine {
namespace {

std::string resolution(const FilmKey& key) {
    return std::to_string(key.width) + "x" + std::to_string(key.height);
}

bool has_same_aovs(const FilmKey& here, const FilmKey& there) {
    for (std::size_t i = 0; i < kAovCount; ++i)
        if (here.has(i) != there.has(i)) return false;
    return here.light_groups == there.light_groups;
}

/// Returns the names of the AOVs for messages.
std::string aov_names(const FilmKey& key) {
    std::string names = "RGB";
    for (std::size_t i = 1; i < kAovCount; ++i)
        if (key.has(i)) names.append(" ").append(kAovs.at(i).name);
    for (const std::string& name : key.light_groups) names += " " + name;
    return names;
}

/// Returns the first lines of two texts that differ.
KeyDifference differing_lines(const std::string& here, const std::string& there) {
    std::istringstream lines(here);
    std::istringstream others(there);
    std::string line;
    std::string other;
    while (true) {
        const bool more = static_cast<bool>(std::getline(lines, line));
        const bool others_more = static_cast<bool>(std::getline(others, other));
        if (!more) line = "nothing";
        if (!others_more) other = "nothing";
        if (!more || !others_more || line != other) return {"setting", line, other};
    }
}

}  // namespace

std::optional<KeyDifference> difference(const FilmKey& here, const FilmKey& there) {
    if (resolution(here) != resolution(there))
        return KeyDifference{"resolution", resolution(here), resolution(there)};
    if (!has_same_aovs(here, there))
        return KeyDifference{"set of AOVs", aov_names(here), aov_names(there)};
    if (here.seed != there.seed)
        return KeyDifference{"seed", std::to_string(here.seed), std::to_string(there.seed)};
    if (here.scene_hash != there.scene_hash) return KeyDifference{"scene", "", ""};
    if (here.settings != there.settings) return differing_lines(here.settings, there.settings);
    if (here.small_passes != there.small_passes)
        return KeyDifference{"number of small passes", std::to_string(here.small_passes),
                             std::to_string(there.small_passes)};
    if (here.alpha != there.alpha) return KeyDifference{"sequence of radii", "", ""};
    if (here.sequential != there.sequential) return KeyDifference{"order of passes", "", ""};
    return {};
}

}  // namespace sunfleck::engine
