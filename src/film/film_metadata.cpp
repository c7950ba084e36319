// Texts from the film's key and statistics.
#include "film/film_metadata.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <string_view>

namespace sunfleck::engine {
namespace {

std::uint64_t photon_paths(const Film& film) {
    double paths = 0;
    for (const char* kind : {"uniform_paths", "guided_paths", "mutated_paths"})
        paths += film.statistic(kind);
    return static_cast<std::uint64_t>(paths);
}

}  // namespace

std::map<std::string, std::string> film_metadata(const Film& film) {
    std::map<std::string, std::string> texts = {
        {"software", "Sunfleck " SUNFLECK_VERSION},
        {"passes", fmt::format("{}", film.pass_count())},
        {"seed", fmt::format("{}", film.key().seed)},
        {"scene_hash", fmt::format("{:016x}", film.key().scene_hash)},
        {"settings", film.key().settings},
    };
    if (const std::uint64_t paths = photon_paths(film); paths > 0)
        texts["photon_paths"] = fmt::format("{}", paths);
    return texts;
}

float pixel_aspect_of(const FilmKey& key) {
    const std::string line = std::string(kPixelAspect) + "=";
    const std::string_view settings = key.settings;
    std::size_t begin = settings.find(line);
    if (begin == std::string_view::npos) return 1;
    begin += line.size();
    float aspect = 1;
    std::from_chars(settings.data() + begin, settings.data() + settings.size(), aspect);
    return aspect;
}

}  // namespace sunfleck::engine
