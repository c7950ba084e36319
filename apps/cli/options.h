// What the commands are asked to do: every flag has its place here.
#pragma once

#include "apps/cli/light_groups.h"
#include "experiment/cell.h"
#include "film/relight.h"
#include "stages/settings.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// What is said on standard error beside errors.
enum class LogLevel {
    quiet,    // nothing
    warning,  // what may make the picture other than expected
    info      // and defaults taken, and the progress line on a terminal
};

struct RenderOptions {
    std::string scene;
    std::vector<std::string> outputs;
    RenderSettings settings;
    StopSettings stop;
    bool ends_by_default = false;  // the command says nothing of an end
    std::vector<AskedLightGroup> light_groups;
    std::optional<int> max_depth;  // wins over the scene's
    std::optional<Vec2i> resolution;
    std::optional<std::array<int, 4>> crop;            // in pixels
    std::optional<std::array<double, 4>> crop_window;  // as fractions of the picture
    std::string isa = "avx2";
    std::string stats;      // file, or empty
    std::string snapshots;  // folder, or empty
    std::size_t threads = 0;
    std::optional<std::uint64_t> memory_limit;  // bytes; else what the machine leaves
    std::string checkpoint;                     // file to write, or empty
    double checkpoint_seconds = 60;             // at least so many between two
    std::string resume;                         // file to go on from, or empty
    double exposure = 0;                        // stops, PNG alone
    LogLevel log = LogLevel::info;
    std::string command;  // as typed, for the record
};

struct InfoOptions {
    std::string scene;
    bool lights = false;  // the list of its lights, too
    bool words = false;   // no scene: the table of all words
};

struct SceneOptions {
    std::string name;  // empty: list them
    std::string folder = ".";
    bool force = false;  // replaces files that differ
};

struct ExperimentOptions {
    std::vector<std::string> names;  // of figures; empty: list them
    RunSettings run;
};

struct MergeOptions {
    std::vector<std::string> inputs;
    std::vector<std::string> outputs;
    std::string stats;
    double exposure = 0;
    bool extrapolate = false;
};

struct RelightOptions {
    std::string picture;
    std::vector<LightGroupFactor> factors;
    std::vector<std::string> outputs;
    double exposure = 0;
};

struct CompareOptions {
    std::string reference;
    std::vector<std::string> inputs;
    std::string report;  // file, or empty
    std::string json;    // file, or empty
};

/// Exactly one of them is set.
struct Options {
    std::optional<RenderOptions> render;
    std::optional<InfoOptions> info;
    std::optional<SceneOptions> scene;
    std::optional<MergeOptions> merge;
    std::optional<RelightOptions> relight;
    std::optional<ExperimentOptions> experiment;
    std::optional<CompareOptions> compare;
};

}  // namespace sunfleck::engine
