// Texts of the warnings about dark pictures.
#include "stats/darkness.h"

#include "film/error_bars.h"

#include <fmt/format.h>

#include <algorithm>

namespace sunfleck::engine {
namespace {

constexpr double kNoticed = 0.01;  // of the picture's light, or of its pixels

/// 1 pass, 6 passes.
std::string passes_text(const Film& film) {
    return fmt::format("{} pass{}", film.pass_count(), film.pass_count() == 1 ? "" : "es");
}

std::string black_text(const Film& film) {
    if (film.statistic("visible_points") == 0)
        return "the picture is black: the camera sees no surface and no light; check its "
               "position and direction";
    return fmt::format(
        "the picture is black: no light reached what the camera sees in {}; the camera may be "
        "inside an object, or objects may enclose the lights",
        passes_text(film));
}

/// Passes without photons lack the light that photons add in other passes.
std::string some_starved_text(const Film& film, double starved, double share) {
    return fmt::format(
        "in {:.0f} of {} passes no photon reached what the camera sees; photons estimate {:.0f}% "
        "of the picture's light, which needs many more passes, or more --photons-per-pass, to "
        "converge",
        starved, film.pass_count(), 100 * share);
}

std::string all_starved_text(const Film& film, double share) {
    return fmt::format(
        "no photon reached what the camera sees in {}: about {:.0f}% of the picture lacks light "
        "that arrives from other surfaces or through glass; render many more passes, or give more "
        "--photons-per-pass",
        passes_text(film), std::max(1.0, 100 * share));
}

}  // namespace

std::vector<std::string> darkness_warnings(const Film& film,
                                           const std::function<double()>& share_lit) {
    std::vector<std::string> lines;
    const double mean = image_mean(film);
    const double starved = film.statistic("starved_passes");
    if (starved > 0 && starved < static_cast<double>(film.pass_count())) {
        const double share = image_mean_by_photons(film) / mean;
        if (share > kNoticed) lines.push_back(some_starved_text(film, starved, share));
    } else if (starved > 0 && share_lit) {
        const double share = share_lit();
        if (share > kNoticed) lines.push_back(all_starved_text(film, share));
    }
    if (mean == 0 && lines.empty()) lines.push_back(black_text(film));
    return lines;
}

}  // namespace sunfleck::engine
