// Options of the commands: one struct per command, one member per flag.
#pragma once

#include "display/address.h"
#include "experiment/cell.h"
#include "film/relight.h"
#include "flags/render_request.h"
#include "import/scene_request.h"
#include "mattes/mattes.h"

#include <optional>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// What the program prints on standard error besides errors.
enum class LogLevel {
    quiet,    // nothing
    warning,  // warnings, too
    info      // also defaults that were taken, and the progress line
};

struct RenderOptions {
    std::string scene;
    SceneRequest scene_request;
    std::vector<std::string> outputs;
    RenderRequest request;
    std::string stats;      // file, or empty
    std::string snapshots;  // folder, or empty
    MatteSettings mattes;   // of .exr; no kinds: none
    std::size_t threads = 0;
    std::optional<std::uint64_t> memory_limit;  // bytes; absent: what the machine leaves
    std::string checkpoint;                     // file to write, or empty
    double checkpoint_seconds = 60;             // least time between two checkpoints
    std::string resume;                         // checkpoint to continue, or empty
    LogLevel log = LogLevel::info;
    bool view = false;         // serve a page that shows the render as it goes on
    bool view_open = false;    // and open it in a browser
    bool view_stay = false;    // and go on serving it when the render has ended
    std::string view_host;     // address to serve it at; empty: this machine alone
    std::string view_against;  // a picture to compare with there, or empty
    std::optional<DisplayAddress> display_server;  // where tev listens
    std::string command;                           // as typed, for the record
};

struct InfoOptions {
    std::string scene;
    SceneRequest scene_request;
    bool lights = false;  // list the lights, too
    bool words = false;   // print the table of scene words; there is no scene then
};

struct SceneOptions {
    std::string name;  // empty: list them
    std::string folder = ".";
    bool force = false;  // replaces files that differ
};

struct ConvertOptions {
    std::string scene;
    SceneRequest scene_request;
    std::string output;  // the main file
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
    Exposure exposure;
    PictureFileOptions files{};
    bool extrapolate = false;
};

struct RelightOptions {
    std::string picture;
    std::vector<LightGroupFactor> factors;
    std::vector<std::string> outputs;
    Exposure exposure;
    PictureFileOptions files{};
};

struct ViewOptions {
    std::string picture;
    std::string against;  // a picture to compare with, or empty
    std::string host;     // address to serve at; empty: this machine alone
    Exposure exposure;
    OutputTransform transform{};  // its tone and white balance
    bool opens = false;           // in a browser
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
    std::optional<ConvertOptions> convert;
    std::optional<MergeOptions> merge;
    std::optional<RelightOptions> relight;
    std::optional<ExperimentOptions> experiment;
    std::optional<CompareOptions> compare;
    std::optional<ViewOptions> view;
};

}  // namespace sunfleck::engine
