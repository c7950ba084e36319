// Flags of the estimators, and what is asked of each single render.
#include "differential/renders.h"

#include "image/exr.h"
#include "sunfleck/error.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace sunfleck::engine::differential {
namespace {

/// Contributions that were not finite and were left out: see docs/reference/stats.md.
int dropped_nonfinite(const std::string& stats) {
    std::ifstream file(stats);
    return nlohmann::json::parse(file).at("dropped_nonfinite").get<int>();
}

}  // namespace

std::string_view name(Kind kind) {
    switch (kind) {
        case Kind::refused:
            return "refused";
        case Kind::late:
            return "late";
        case Kind::values:
            return "values";
        case Kind::threads:
            return "threads";
        case Kind::resume:
            return "resume";
        case Kind::light:
            return "light";
        case Kind::discs:
            return "discs";
        case Kind::error_bars:
            break;
    }
    return "error-bars";
}

namespace ways {

Way adaptive() {
    return {"default", {"--photons-per-pass", "10000"}, 16, 0};
}

Way photons(const std::string& name) {
    Way way{name, {"--photons-per-pass", "20000"}, 16, 1};
    if (name == "uniform" || name == "random") {
        way.flags.emplace_back("--photon-sampler");
        way.flags.push_back(name);
    } else {
        way.flags.emplace_back("--direct");
        way.flags.emplace_back("photons");
    }
    return way;
}

Way path() {
    return {"path", {"--integrator", "path"}, 128, 2};
}

Way pairs() {
    return {"bdpt", {"--integrator", "bdpt"}, 96, 3};
}

Way with_small_discs(Way way) {
    way.flags.emplace_back("--radius-pixels");
    way.flags.emplace_back("0.3");
    way.seeds += 4;
    return way;
}

Way with_bias(Way way) {
    way.passes = 64;
    way.seeds += 6;
    return way;
}

}  // namespace ways

Ended Renders::run(const Words& words, std::optional<std::chrono::milliseconds> interrupt_after) {
    Words all = {"render", place_.scene, "--log-level", "quiet"};
    all.insert(all.end(), words.begin(), words.end());
    Ended ended = program_->run(place_.folder, all, interrupt_after);
    seconds_ += ended.seconds;
    if (ended.is_late) throw RenderFault({Kind::late, ended.text()});
    return ended;
}

Picture Renders::render(const Way& way, std::uint64_t index) {
    const std::string picture_file = place_.folder + "/look.exr";
    const std::string stats_file = place_.folder + "/look.json";
    std::filesystem::remove(picture_file);
    std::filesystem::remove(stats_file);
    const std::uint64_t seed = (place_.seed * 8 + way.seeds) * 1000 + index;
    Words words = {"-o",       picture_file,         "--stats",
                   stats_file, "--passes",           std::to_string(way.passes),
                   "--seed",   std::to_string(seed), "--nthreads",
                   "1"};
    words.insert(words.end(), way.flags.begin(), way.flags.end());
    const Ended ended = run(words);
    const auto fail = [&](Kind kind, const std::string& text) {
        throw RenderFault({kind, way.name + ": " + text});
    };
    if (ended.code != 0) fail(Kind::refused, ended.text());
    if (!std::filesystem::exists(picture_file) || !std::filesystem::exists(stats_file))
        fail(Kind::refused, "no picture, though the exit code is 0");
    Picture picture = read_exr(picture_file);
    if (const auto broken = broken_values(picture, place_.may_be_negative))
        fail(Kind::values, *broken);
    if (dropped_nonfinite(stats_file) != 0)
        fail(Kind::values, "contributions that are not finite were left out");
    return picture;
}

std::vector<Look> Renders::looks(const Way& way, std::uint64_t first, std::uint64_t count) {
    std::vector<Look> all;
    for (std::uint64_t i = first; i < first + count; ++i) all.push_back(look_at(render(way, i)));
    return all;
}

}  // namespace sunfleck::engine::differential
