// `sunfleck render`: scene in, pictures out.
#include "apps/cli/checkpoints.h"
#include "apps/cli/commands.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/outputs.h"
#include "apps/cli/progress.h"
#include "apps/cli/snapshots.h"
#include "apps/cli/stats.h"
#include "core/hash.h"
#include "core/parallel.h"
#include "core/stopwatch.h"
#include "image/atomic_file.h"
#include "import/load.h"
#include "scene/adjust.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace sunfleck {
namespace {

/// The scene's own film name, as a picture that we write, where no -o is given.
std::vector<std::string> outputs_of(const RenderOptions& options, const SceneDescription& scene) {
    if (!options.outputs.empty()) return options.outputs;
    const std::string name = scene.film.filename.empty() ? "out.exr" : scene.film.filename;
    return {std::filesystem::path(name).filename().replace_extension(".exr").string()};
}

std::vector<SceneFileHash> hashes_of(const std::vector<std::string>& files) {
    std::vector<SceneFileHash> hashes;
    for (const std::string& name : files) {
        std::ifstream file(name, std::ios::binary);
        const std::string bytes((std::istreambuf_iterator<char>(file)), {});
        hashes.push_back({name, hash_text(bytes)});
    }
    return hashes;
}

/// Of the bytes of all files in their order, whatever their names.
std::uint64_t joined(const std::vector<SceneFileHash>& files) {
    std::uint64_t hash = hash_text("");
    for (const SceneFileHash& file : files) hash = hash_joined(hash, file.hash);
    return hash;
}

RenderSettings settings_of(const RenderOptions& options, const RenderHints& hints) {
    RenderSettings settings = options.settings;
    if (options.max_depth) {
        settings.transport.max_depth = *options.max_depth;
    } else if (hints.max_depth) {
        settings.transport.max_depth = *hints.max_depth;
    } else if (options.log == LogLevel::info) {
        fmt::print(stderr, "no greatest depth in scene and command: --max-depth {}\n",
                   settings.transport.max_depth);
    }
    return settings;
}

void print_lines(const std::vector<std::string>& lines, LogLevel log) {
    if (log == LogLevel::quiet) return;
    for (const std::string& line : lines) fmt::print(stderr, "{}\n", line);
}

/// What is to be said before the render.
std::vector<std::string> warnings_of(const RenderOptions& options, const Scene& scene) {
    std::vector<std::string> lines;
    for (const auto& entry : scene.warnings().entries()) lines.push_back(entry.line());
    if (options.isa == "avx2" && !cpu_has_avx2())
        lines.emplace_back(
            "this machine has no AVX2: bytes may differ from those of other machines");
    if (options.settings.photon.sampler == PhotonSampler::paper)
        lines.emplace_back(
            "sampler paper: its counts are pooled while the view and the radii change, so the "
            "picture is biased until it has converged, and has no error bars; adaptive is not");
    return lines;
}

void set_times(RunFacts& facts, const RenderState& state) {
    facts.seconds = state.seconds;
    facts.radius_factor = state.radius_factor;
    facts.total_seconds = facts.load_seconds + state.total_seconds;
    facts.cpu_seconds = state.cpu_seconds;
}

/// Renders with a progress line, and with snapshots and checkpoints if they are wanted.
/// @param earlier  of the same render.
RenderResult render_on(const RenderOptions& options, const RenderJob& job,
                       std::optional<RenderState> earlier, RunFacts& facts,
                       const std::function<void(const RenderState&)>& save) {
    ProgressLine line(options.log == LogLevel::info);
    RenderHooks hooks;
    hooks.report = [&](const Progress& p) { line.show(p); };
    hooks.interrupted = &InterruptGuard::interrupted();
    if (!options.snapshots.empty())
        hooks.snapshot = [&](const RenderResult& so_far) {
            set_times(facts, so_far);
            InterruptGuard::finish_first(
                [&] { write_snapshot(options.snapshots, so_far.film, facts); });
        };
    if (!options.checkpoint.empty()) hooks.save = save;
    hooks.save_every = options.checkpoint_seconds;
    return render(job, hooks, std::move(earlier));
}

}  // namespace

int run_render(const RenderOptions& options) {
    const Stopwatch clock;
    const ThreadLimit limit(options.threads);
    if (!options.outputs.empty()) check_outputs(options.outputs, options.stats);
    std::optional<Checkpoint> checkpoint = open_checkpoints(options);
    SceneDescription description = load_scene(options.scene);
    if (!options.camera.empty())
        throw Error({"--camera"},
                    "there is no camera \"" + options.camera + "\": a pbrt scene has one, unnamed",
                    "leave --camera out");
    const std::vector<std::string> outputs = outputs_of(options, description);
    check_outputs(outputs, options.stats);
    if (!options.snapshots.empty()) prepare_snapshots(options.snapshots, checkpoint.has_value());
    if (options.resolution) set_resolution(description, *options.resolution);
    if (options.settings.energy_compensation) compensate_energy(description);
    if (options.crop) set_crop(description, *options.crop);
    const Origin origin{SUNFLECK_VERSION, options.isa, hashes_of(description.files)};
    const Scene scene(std::move(description), options.isa);
    const InterruptGuard guard;
    const RenderSettings settings = settings_of(options, scene.hints());
    const RenderJob job{scene, settings, options.stop, joined(origin.files)};
    if (checkpoint) check_same_render(options.resume, *checkpoint, origin, job);
    RunFacts facts{options.scene, options.command, options.isa, thread_count(), 0, 0, 0, {}, 1, {}};
    facts.warnings = warnings_of(options, scene);
    print_lines(facts.warnings, options.log);
    facts.load_seconds = clock.seconds();

    CheckpointKeeper keeper(options);
    std::optional<RenderState> earlier;
    if (checkpoint) earlier = std::move(checkpoint->state);
    const RenderResult result =
        render_on(options, job, std::move(earlier), facts,
                  [&](const RenderState& state) { keeper.save(origin, state); });
    InterruptGuard::finish_first([&] { write_outputs(outputs, result.film, options.exposure); });
    // Without a light the picture is black for sure, and that has been said.
    const auto doubts =
        scene.lights().empty() ? std::vector<std::string>() : reliability_warnings(result.film);
    print_lines(doubts, options.log);
    facts.warnings.insert(facts.warnings.end(), doubts.begin(), doubts.end());
    set_times(facts, result);
    if (!options.stats.empty()) {
        const std::string json = stats_json(result.film, facts);
        InterruptGuard::finish_first([&] { write_file(options.stats, json); });
    }
    keeper.finish();
    return result.interrupted ? 130 : 0;
}

}  // namespace sunfleck
