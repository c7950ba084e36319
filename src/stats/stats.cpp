// Statistics of the film as JSON, and warnings from them.
#include "stats/stats.h"

#include "film/error_bars.h"
#include "planning/epoch.h"
#include "render/count_pass.h"
#include "stats/image_stats.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace sunfleck::engine {
namespace {

using Json = nlohmann::ordered_json;

/// Of the names in stats.json: docs/reference/stats.md.
constexpr int kFormat = 3;

struct Fraction {
    double value = 0;
    double error = 0;  // standard, from the spread of passes
};

Fraction visible_fraction(const Film& film) {
    const auto passes = static_cast<double>(film.pass_count());
    const double value = film.statistic("visible_fraction") / passes;
    const double square = film.statistic("visible_fraction_square") / kSquareUnits / passes;
    const double variance = std::max(0.0, square - value * value);
    return {value, passes > 1 ? std::sqrt(variance / (passes - 1)) : 0};
}

/// Returns how many independent paths the chains of a run descend from; null without chains.
Json lineages_json(const Film& film, const std::string& name) {
    const double runs = film.statistic(name + "runs");
    if (runs == 0) return nullptr;
    return {{"runs", static_cast<std::uint64_t>(runs)},
            {"fewer_than_16", film.statistic(name + "fewer_than_16") / runs},
            {"one_has_half", film.statistic(name + "one_has_half") / runs},
            {"largest_share", film.statistic(name + "largest_share") / runs}};
}

/// Returns, over all passes with splitting, the surviving fraction of each level and the acceptance
/// rates.
/// @param name  prefix of a light stratum's statistics; empty: all lights together.
Json splitting_json(const Film& film, const std::string& name = "") {
    Json fractions = Json::array();
    Json acceptance = Json::array();
    const auto statistic = [&](std::size_t level, const char* what) {
        return film.statistic(fmt::format("{}splitting.{}.{}", name, level, what));
    };
    std::size_t levels = 0;
    for (; statistic(levels, "states") > 0; ++levels) {
        if (levels > 0)
            acceptance.push_back(statistic(levels, "accepted") /
                                 std::max(1.0, statistic(levels, "proposed")));
        if (statistic(levels + 1, "states") > 0 || levels == 0)
            fractions.push_back(statistic(levels, "survivors") / statistic(levels, "states"));
    }
    return {{"levels", levels == 0 ? 0 : levels - 1},
            {"fractions", fractions},
            {"acceptance", acceptance},
            {"lineages", lineages_json(film, name + "lineages.")}};
}

/// Returns the means of each light stratum over the passes with strata.
Json strata_json(const Film& film) {
    Json strata = Json::array();
    while (true) {
        const std::string name = fmt::format("stratum.{}.", strata.size());
        const auto statistic = [&](const char* what) { return film.statistic(name + what); };
        const double passes = statistic("passes");
        if (passes == 0) return strata;
        strata.push_back(
            {{"passes", static_cast<std::uint64_t>(passes)},
             {"power_share", statistic("power_share") / passes},
             {"visible_fraction", statistic("visible_fraction") / passes},
             {"paths", statistic("paths") / passes},
             {"starved_passes", static_cast<std::uint64_t>(statistic("starved_passes"))},
             {"splitting", splitting_json(film, name)}});
    }
}

/// Returns the epochs of the rendered passes, with the photon paths of a pass.
Json epochs_json(const Film& film) {
    const auto pixels = static_cast<double>(film.key().pixels());
    Json epochs = Json::array();
    for (std::uint32_t number = 0; number <= epoch_of(~0U); ++number) {
        const std::string name = fmt::format("epoch.{}.", number);
        const double passes = film.statistic(name + "passes");
        if (passes == 0) continue;
        epochs.push_back(
            {{"epoch", number},
             {"passes", static_cast<std::uint64_t>(passes)},
             {"camera_paths_per_pixel", film.statistic(name + "camera_paths") / passes / pixels},
             {"photons_per_pass", film.statistic(name + "paths") / passes},
             {"indirect", name_of(indirect_of(film))}});
    }
    return epochs;
}

/// Returns the visible fraction of traced paths over that of uniform paths.
Json visible_ratio(const Film& film, const char* visible) {
    const double traced = film.statistic("uniform_paths") + film.statistic("guided_paths") +
                          film.statistic("mutated_paths");
    const double fraction = visible_fraction(film).value;
    if (traced == 0 || fraction == 0) return nullptr;
    return film.statistic(visible) / traced / fraction;
}

/// Returns the last theta of the sampler `paper`.
Json mutation_size(const Film& film) {
    const double theta = film.statistic("mutation_size");
    return theta > 0 ? Json(theta) : Json();
}

/// Returns the acceptance rate of the mutations.
Json acceptance(const Film& film) {
    const double mutated = film.statistic("mutated_paths");
    return mutated > 0 ? Json(film.statistic("accepted_paths") / mutated) : Json();
}

Json settings_json(const FilmKey& key) {
    Json json = Json::object();
    std::size_t begin = 0;
    while (begin < key.settings.size()) {
        const std::size_t end = std::min(key.settings.find('\n', begin), key.settings.size());
        const std::string line = key.settings.substr(begin, end - begin);
        const std::size_t equals = line.find('=');
        if (equals != std::string::npos) json[line.substr(0, equals)] = line.substr(equals + 1);
        begin = end + 1;
    }
    return json;
}

std::uint64_t count(const Film& film, const char* name) {
    return static_cast<std::uint64_t>(film.statistic(name));
}

void add_counts(const Film& film, std::initializer_list<const char*> names, Json& json) {
    for (const char* name : names) json[name] = count(film, name);
}

/// Adds what was rendered.
void add_render(const Film& film, const RunFacts& facts, Json& json) {
    json["format"] = kFormat;
    json["version"] = SUNFLECK_VERSION;
    json["scene"] = facts.scene;
    json["command"] = facts.command;
    json["settings"] = settings_json(film.key());
    json["seed"] = film.key().seed;
    json["threads"] = facts.threads;
    json["ranks"] = facts.ranks;
    json["isa"] = facts.isa;
    json["resolution"] = {film.key().width, film.key().height};
    json["passes"] = film.pass_count();
    for (const PassRange& range : film.passes().ranges())
        json["pass_ranges"].push_back({range.begin, range.end});
    json["batches"] = static_cast<std::uint64_t>(film.batches().count);
}

/// Returns the seconds of each stage. "photon" includes deposits, which are made while tracing.
Json seconds_json(const RunFacts& facts) {
    return {{"load", facts.load_seconds},     {"build", facts.seconds.build},
            {"camera", facts.seconds.camera}, {"index", facts.seconds.index},
            {"photon", facts.seconds.photon}, {"learn", facts.seconds.learn},
            {"total", facts.total_seconds}};
}

Json photon_paths_json(const Film& film) {
    return {{"uniform", count(film, "uniform_paths")},
            {"uniform_visible", count(film, "uniform_visible")},
            {"guided", count(film, "guided_paths")},
            {"guided_visible", count(film, "guided_visible")},
            {"mutated", count(film, "mutated_paths")},
            {"accepted", count(film, "accepted_paths")},
            {"distinct_visible", count(film, "distinct_visible")},
            {"deposited", count(film, "visible_states")}};
}

/// Adds how photon paths were sampled, with the statistics of the samplers.
void add_sampling(const Film& film, Json& json) {
    json["photon_paths"] = photon_paths_json(film);
    json["epochs"] = epochs_json(film);
    json["splitting"] = splitting_json(film);
    json["light_strata"] = strata_json(film);
    json["visible_photon_ratio"] = visible_ratio(film, "distinct_visible");
    json["visible_photon_ratio_with_repeats"] = visible_ratio(film, "visible_states");
    json["mutation_size"] = mutation_size(film);
    add_counts(film, {"theta_floor_held"}, json);
    json["acceptance"] = acceptance(film);
    add_counts(film, {"photons_stored", "deposits", "starved_passes"}, json);
    const Fraction fraction = visible_fraction(film);
    json["visible_fraction"] = {{"value", fraction.value}, {"std_error", fraction.error}};
}

}  // namespace

std::string stats_json(const Film& film, const RunFacts& facts) {
    Json json;
    add_render(film, facts, json);
    json["seconds"] = seconds_json(facts);
    json["cpu_seconds"] = facts.cpu_seconds;
    json["rays"] = {{"camera", count(film, "camera_rays")}, {"photon", count(film, "photon_rays")}};
    add_counts(film, {"visible_points"}, json);
    add_sampling(film, json);
    json["radius_factor"] = facts.radius_factor;
    add_counts(film, {"dropped_nonfinite", "saturated", "saturated_squares", "escaped", "too_long"},
               json);
    json["image"] = image_json(film, facts.error_terms);
    json["warnings"] = facts.warnings;
    // Names of files may be any bytes; JSON is UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::string> reliability_warnings(const Film& film) {
    std::vector<std::string> lines;
    const Fraction visible = visible_fraction(film);
    if (visible.error > 0.1 * visible.value)
        lines.push_back(fmt::format(
            "the visible fraction of photon paths is known to {:.0f}% only, from the spread "
            "between {} passes: {:.2g} +- {:.2g}; the sum of the photons' light may be as "
            "uncertain",
            100 * visible.error / visible.value, film.pass_count(), visible.value, visible.error));
    const auto error = film.batches().count < kTargetBatches ? std::nullopt : image_error(film);
    const double brightness = error ? widening(film) * error->standard_error : 0;
    if (error && error->mean > 0 && brightness > 0.05 * error->mean)
        lines.push_back(
            fmt::format("the brightness of the whole picture is uncertain by {:.0f}%, "
                        "from {} batches of passes: render more",
                        100 * brightness / error->mean, film.batches().count));
    if (is_too_dim(film))
        lines.push_back(
            fmt::format("the picture is so dark, {:.2g} on average, that its error bars "
                        "are not known; scale the lights up",
                        image_mean(film)));
    const double dropped = film.statistic("dropped_nonfinite");
    if (dropped > 0)
        lines.push_back(
            fmt::format("{:.0f} contributions were not finite and were left out", dropped));
    const double cut = film.statistic("saturated");
    if (cut > 0)
        lines.push_back(
            fmt::format("{:.0f} contributions were larger than {:.1g} and were cut: "
                        "the picture is too dark there",
                        cut, kLargestTerm));
    const double squares = film.statistic("saturated_squares");
    if (squares > 0)
        lines.push_back(
            fmt::format("error bars are too small where the picture is brighter than "
                        "{:.1g}, in {:.0f} cases",
                        std::sqrt(kLargestTerm), squares));
    return lines;
}

}  // namespace sunfleck::engine
