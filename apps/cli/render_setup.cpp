// What comes before the first pass of `sunfleck render`.
#include "apps/cli/render_setup.h"

#include "apps/cli/outputs.h"
#include "apps/cli/snapshots.h"
#include "core/hash.h"
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

std::vector<SceneFileHash> hashes_of(const SceneDescription& scene) {
    std::vector<SceneFileHash> hashes;
    for (const std::string& name : scene.files) {
        if (scene.text && name == scene.path) {
            hashes.push_back({name, hash_text(*scene.text)});
            continue;
        }
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
    }
    return settings;
}

void adjust(SceneDescription& description, const RenderOptions& options) {
    if (options.resolution) set_resolution(description, *options.resolution);
    if (options.settings.energy_compensation) compensate_energy(description);
    if (options.crop) set_crop(description, *options.crop);
}

}  // namespace

RenderSetup::RenderSetup(const RenderOptions& from, SceneDescription description)
    : options(from),
      origin{SUNFLECK_VERSION, from.isa, hashes_of(description)},
      scene(std::move(description), from.isa),
      job{scene, settings_of(from, scene.hints()), from.stop, joined(origin.files)} {
    job.settings.transport.light_layers = light_layers_of(scene, from.light_layers);
}

RenderOptions options_of(const RenderOptions& options, const Ranks& ranks) {
    RenderOptions mine = options;
    if (ranks.is_first()) return mine;
    for (std::string* file : {&mine.stats, &mine.snapshots, &mine.checkpoint, &mine.resume})
        file->clear();
    mine.outputs.clear();
    mine.log = LogLevel::quiet;
    return mine;
}

std::unique_ptr<RenderSetup> prepare(const RenderOptions& options, const Ranks& ranks) {
    check_shareable(options.settings, ranks);
    if (options.scene == "-" && !ranks.is_alone())
        throw Error({"-"}, "standard input is that of one rank alone",
                    "write the scene to a file that all ranks can read");
    check_outputs(options.outputs, {options.stats, options.checkpoint});
    std::optional<Checkpoint> checkpoint = open_checkpoints(options);
    SceneDescription description = load_scene(options.scene);
    adjust(description, options);
    std::vector<std::string> outputs;
    if (ranks.is_first()) outputs = outputs_of(options, description);
    if (options.outputs.empty()) check_outputs(outputs, {options.stats, options.checkpoint});
    if (!options.snapshots.empty()) prepare_snapshots(options.snapshots, checkpoint.has_value());
    auto setup = std::make_unique<RenderSetup>(options, std::move(description));
    setup->checkpoint = std::move(checkpoint);
    setup->outputs = std::move(outputs);
    if (setup->checkpoint)
        check_same_render(options.resume, *setup->checkpoint, setup->origin, key_of(setup->job),
                          setup->job.stop);
    return setup;
}

}  // namespace sunfleck
