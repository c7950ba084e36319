// What comes before the first pass of `sunfleck render`.
#include "apps/cli/render_setup.h"

#include "apps/cli/outputs.h"
#include "apps/cli/snapshots.h"
#include "core/file_identity.h"
#include "core/hash.h"
#include "core/memory_room.h"
#include "flags/scene_flags.h"
#include "image/read_file.h"
#include "import/load.h"
#include "render/memory_estimate.h"
#include "render/progressive.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

namespace sunfleck::engine {
namespace {

/// The scene's own film name, as a picture that we write, where no -o is given.
std::vector<std::string> outputs_of(const RenderOptions& options, const SceneDescription& scene) {
    if (!options.outputs.empty()) return options.outputs;
    const std::string name = scene.film.filename.empty() ? "out.exr" : scene.film.filename;
    return {std::filesystem::path(name).filename().replace_extension(".exr").string()};
}

std::vector<SceneFileHash> hashes_of(const SceneDescription& scene, const SceneRequest& request) {
    std::vector<SceneFileHash> hashes;
    for (const std::string& name : scene.files) {
        const bool is_text = scene.text && name == scene.path;
        hashes.push_back({name, hash_text(is_text ? *scene.text : read_file(name))});
    }
    if (!request.given.empty())
        hashes.push_back({"the flags of the scene", hash_text(text_of(request))});
    return hashes;
}

/// Of the bytes of all files in their order, whatever their names.
std::uint64_t joined(const std::vector<SceneFileHash>& files) {
    std::uint64_t hash = hash_text("");
    for (const SceneFileHash& file : files) hash = hash_joined(hash, file.hash);
    return hash;
}

/// @param read  files of the scene.
CommandFiles files_of(const RenderOptions& options, std::vector<std::string> read,
                      const std::vector<std::string>& outputs) {
    CommandFiles files{std::move(read), outputs, options.snapshots};
    // A render goes on in the checkpoint that it was resumed from.
    const bool goes_on = identity_of(options.resume) == identity_of(options.checkpoint);
    if (!goes_on) files.inputs.push_back(options.resume);
    files.outputs.insert(files.outputs.end(), {options.stats, options.checkpoint});
    return files;
}

/// Returns what a page takes: the picture that viewers read, and the next one.
std::uint64_t bytes_of_page(const RenderJob& job, std::uint64_t pixels) {
    constexpr std::uint64_t kUsual = 3 + 1 + 3;  // light, error, bias
    return 2 * (kUsual + asked_channels(job.settings)) * sizeof(float) * pixels;
}

/// Returns what mattes take: their channels, and those in the picture that is written.
std::uint64_t bytes_of_mattes(const RenderOptions& options, std::uint64_t pixels) {
    return 2 * options.mattes.kinds.size() * 2 * kMatteIds * sizeof(float) * pixels;
}

/// @throws Error if the render, its scene being in memory, would need more than there is.
void check_memory(const RenderJob& job, const RenderOptions& options) {
    const PixelWindow window = window_of(job.scene.film());
    const std::uint64_t of_page = options.view ? bytes_of_page(job, window.pixels()) : 0;
    const std::uint64_t needed = memory_in_use() + render_bytes(job).usual + of_page +
                                 bytes_of_mattes(options, window.pixels());
    const auto& limit = options.memory_limit;
    const MemoryRoom room = limit ? MemoryRoom{*limit, "--memory-limit"} : memory_room();
    if (needed <= room.bytes) return;
    throw Error(
        {"sunfleck render"},
        fmt::format("{} x {} pixels need about {} of memory, and there are {} ({})", window.width(),
                    window.height(), memory_text(needed), memory_text(room.bytes), room.limit),
        "render fewer pixels (--resolution, --crop), or raise --memory-limit");
}

}  // namespace

RenderSetup::RenderSetup(const RenderOptions& from, SceneDescription description)
    : options(from),
      origin{SUNFLECK_VERSION, from.request.isa, hashes_of(description, from.scene_request)},
      scene(std::move(description), from.request.isa),
      job{scene, settings_for(scene, from.request), from.request.stop, joined(origin.files)} {}

RenderOptions options_of(const RenderOptions& options, const Ranks& ranks) {
    RenderOptions mine = options;
    if (ranks.is_first()) return mine;
    for (std::string* file : {&mine.stats, &mine.snapshots, &mine.checkpoint, &mine.resume})
        file->clear();
    mine.outputs.clear();
    mine.mattes.kinds.clear();
    mine.log = LogLevel::quiet;
    return mine;
}

std::vector<std::string> written_files(const RenderSetup& setup) {
    const RenderOptions& options = setup.options;
    std::vector<std::string> files = setup.outputs;
    files.insert(files.end(), {options.stats, options.checkpoint});
    if (options.snapshots.empty()) return files;
    for (std::string& claim : claims_of_snapshots(options.snapshots))
        files.push_back(std::move(claim));
    return files;
}

std::unique_ptr<RenderSetup> prepare(const RenderOptions& options, const Ranks& ranks) {
    check_shareable(options.request.settings, ranks);
    if (options.scene == "-" && !ranks.is_alone())
        throw Error({"-"}, "only one rank can read standard input",
                    "write the scene to a file that all ranks can read");
    check_outputs(options.outputs, {options.stats, options.checkpoint});
    check_apart(files_of(options, {options.scene}, options.outputs));
    std::optional<Checkpoint> checkpoint = open_checkpoints(options);
    SceneDescription description = load_scene(options.scene, options.scene_request);
    adjust_scene(description, options.request);
    std::vector<std::string> outputs;
    if (ranks.is_first()) outputs = outputs_of(options, description);
    if (options.outputs.empty()) check_outputs(outputs, {});
    check_apart(files_of(options, description.files, outputs));
    if (!options.snapshots.empty()) prepare_snapshots(options.snapshots, checkpoint.has_value());
    auto setup = std::make_unique<RenderSetup>(options, std::move(description));
    check_memory(setup->job, options);
    setup->checkpoint = std::move(checkpoint);
    setup->outputs = std::move(outputs);
    if (setup->checkpoint)
        check_same_render(options.resume, *setup->checkpoint, setup->origin, key_of(setup->job),
                          setup->job.stop);
    return setup;
}

}  // namespace sunfleck::engine
