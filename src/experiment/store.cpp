// Cells on the disk.
#include "experiment/store.h"

#include "core/snapshot_names.h"
#include "experiment/child.h"
#include "image/atomic_file.h"
#include "image/read_file.h"
#include "procedural/scenes.h"
#include "sunfleck/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Processor seconds of a cell from which checkpoints are written.
constexpr double kWorthKeeping = 120;
constexpr const char* kCheckpoint = "/render.ckpt";

/// Returns whether the scene's errors are shown over time, so that its snapshots are kept.
bool keeps_series(const std::string& scene) {
    return scene == "room" || scene == "two-windows" || scene == "magnifier";
}

/// Returns whether errors of the scene leave out pixels that see a lamp (results.h).
bool marks_lamps(const std::string& scene) {
    return scene == "box";
}

/// Returns the resolution of scenes whose size the paper gives.
std::string resolution(const std::string& scene, double scale) {
    const auto side = [&](double pixels) { return std::max(1L, std::lround(pixels * scale)); };
    return scene == "magnifier" ? fmt::format("{}x{}", side(640), side(480))
                                : fmt::format("{0}x{0}", side(512));
}

/// Returns the settings that must be equal to continue. Seeds and figures may be added.
Json record(const RunSettings& s) {
    return {{"version", SUNFLECK_VERSION},
            {"cpu_seconds", s.passes > 0 ? 0.0 : s.cpu_seconds},
            {"passes", s.passes},
            {"reference_budget", s.reference_budget},
            {"scale", s.scale},
            {"threads", s.threads}};
}

void make_folder(const fs::path& folder) {
    std::error_code fault;
    fs::create_directories(folder, fault);
    if (fault)
        throw Error({folder.string()}, "cannot create this folder: " + fault.message(),
                    "give another folder with -o");
}

/// Returns whether the snapshot has a power of two of passes (passes-000064.exr); others are ends
/// of partial renders.
bool is_on_the_way(const fs::path& picture) {
    return std::has_single_bit(std::stoul(picture.stem().string().substr(7)));
}

/// Removes snapshots except the last one, and except those of the series if it is kept.
void drop_pictures(const fs::path& folder, bool keep_series) {
    for (const std::string_view name : {kLatestExr, kLatestPng}) fs::remove(folder / name);
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".exr") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (std::size_t i = 0; i + 1 < files.size(); ++i) {
        if (keep_series && is_on_the_way(files[i])) continue;
        fs::remove(files[i]);
        fs::remove(fs::path(files[i]).replace_extension(".json"));
    }
}

}  // namespace

std::string write_scene(const std::string& folder, const std::vector<SceneFile>& files) {
    for (std::size_t i = files.size(); i-- > 0;) {
        const fs::path path = fs::path(folder) / files[i].name;
        make_folder(path.parent_path());
        write_file(path.string(), files[i].bytes);
    }
    return (fs::path(folder) / files.front().name).string();
}

CellStore::CellStore(RunSettings settings) : settings_(std::move(settings)) {
    make_folder(settings_.folder);
    const std::string path = settings_.folder + "/run.json";
    const Json wanted = record(settings_);
    if (!fs::exists(path)) {
        write_file(path, wanted.dump(2) + "\n");
        return;
    }
    const Json found = Json::parse(read_file(path), nullptr, false);
    for (const auto& [name, value] : wanted.items()) {
        const Json before = found.is_object() && found.contains(name) ? found[name] : Json();
        if (before != value)
            throw Error(
                {path},
                fmt::format("was begun with {} {}, not {}", name, before.dump(), value.dump()),
                "use the same value, or another folder with -o");
    }
}

std::string CellStore::folder(const Cell& cell) const {
    return settings_.folder + "/cells/" + cell.key();
}

bool CellStore::has(const Cell& cell) const {
    return fs::is_directory(folder(cell));
}

double CellStore::expected_seconds(const Cell& cell) const {
    return settings_.passes > 0 ? 0 : settings_.cpu_seconds * cell.budget;
}

std::string CellStore::scene_file(const std::string& scene) const {
    const fs::path base = fs::path(settings_.folder) / "scenes" / scene;
    const fs::path main = base / (scene + ".pbrt");
    if (fs::exists(main)) return main.string();
    return write_scene(base.string(), make_scene(scene));
}

std::vector<std::string> CellStore::command(const Cell& cell, const std::string& target) const {
    std::vector<std::string> words = {settings_.program, "render", scene_file(cell.scene)};
    words.insert(words.end(), cell.method.flags.begin(), cell.method.flags.end());
    const auto add = [&](const char* flag, const std::string& value) {
        words.insert(words.end(), {flag, value});
    };
    add("--seed", std::to_string(cell.seed));
    add("--resolution", resolution(cell.scene, settings_.scale));
    if (settings_.passes > 0)
        add("--passes", std::to_string(std::lround(std::ceil(settings_.passes * cell.budget))));
    else
        add("--cpu-time", fmt::format("{:.3f}s", settings_.cpu_seconds * cell.budget));
    if (settings_.threads > 0) add("--nthreads", std::to_string(settings_.threads));
    if (marks_lamps(cell.scene)) add("--aovs", "emission");
    add("--log-level", "warning");
    add("--snapshots", target);
    add("-o", target + "/last.png");
    if (settings_.passes == 0 && expected_seconds(cell) < kWorthKeeping) return words;
    add("--checkpoint", target + kCheckpoint);
    if (fs::exists(target + kCheckpoint)) add("--resume", target + kCheckpoint);
    return words;
}

void CellStore::run(const Cell& cell, const std::atomic<bool>* interrupted) const {
    const fs::path done = folder(cell);
    const fs::path part = done.string() + ".part";
    const fs::path checkpoint = part.string() + kCheckpoint;
    if (!fs::exists(checkpoint)) fs::remove_all(part);
    make_folder(part);
    const std::string log = (part / "log.txt").string();
    const ChildEnd end = run_child(command(cell, part.string()), log, interrupted);
    if (interrupted != nullptr && interrupted->load()) {
        if (!fs::exists(checkpoint)) fs::remove_all(part);
        throw Interrupted{};
    }
    check_render(end, log);
    drop_pictures(part, keeps_series(cell.scene));
    fs::remove(checkpoint);
    fs::rename(part, done);
}

}  // namespace sunfleck::engine
