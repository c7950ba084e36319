// The command line, read: every flag has its place here and its row in options.cpp or
// *_options.cpp.
#pragma once

#include "apps/cli/light_layers.h"
#include "experiment/cell.h"
#include "film/relight.h"
#include "render/settings.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace sunfleck {

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
    std::vector<AskedLightLayer> light_layers;
    std::optional<int> max_depth;  // wins over the scene's
    std::optional<Vec2i> resolution;
    std::optional<std::array<int, 4>> crop;
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
    std::vector<LayerFactor> factors;
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

/// Reads the command line. @return nothing when all has been said (--help, --version): exit 0.
/// @throws Error with place "sunfleck" or the flag for anything that cannot be used.
std::optional<Options> read_options(int count, const char* const* words);

/// "60s", "5m", "2h", "90" (seconds). @throws Error naming the flag.
double read_duration(const std::string& text, const std::string& flag);
/// "2%" or "0.02". @throws Error naming the flag.
double read_share(const std::string& text, const std::string& flag);
/// "4G", "512MiB": bytes, in powers of 1024. @throws Error naming the flag.
std::uint64_t read_bytes(const std::string& text, const std::string& flag);
/// A number in (0, most). @throws Error naming the flag.
double read_positive(const std::string& text, const std::string& flag, int most);
/// "42": 0 to 2^64 - 1. @throws Error naming the flag.
std::uint64_t read_seed(const std::string& text, const std::string& flag);
/// "640x480". @throws Error naming the flag.
Vec2i read_size(const std::string& text, const std::string& flag);
/// NAME=FACTOR or NAME=R,G,B. @throws Error naming the text.
LayerFactor read_factor(const std::string& text);
/// "a,b,c,d". @throws Error naming the flag.
std::array<int, 4> read_crop(const std::string& text, const std::string& flag);
/// "caustic,depth"; empty: none. @throws Error naming the flag.
LayerSet read_layers(const std::string& text, const std::string& flag);
/// "a:b", into first and end pass. @throws Error naming the flag.
void read_pass_range(const std::string& text, const std::string& flag, StopSettings& stop);

}  // namespace sunfleck
