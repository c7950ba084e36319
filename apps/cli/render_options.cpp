// Reading the flags of `sunfleck render`, row by row.
#include "apps/cli/render_options.h"

#include "apps/cli/number_check.h"
#include "apps/cli/values.h"
#include "core/named_rows.h"
#include "image/picture_file.h"
#include "photon_samplers/samplers.h"
#include "sunfleck/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace sunfleck::engine {
namespace {

/// An option that takes one of the names of a table, whose rows say what each means.
template <class Rows>
void add_choice(CLI::App& app, const char* flag, std::string& text, const Rows& rows) {
    std::string what;
    std::vector<std::string> names;
    for (const auto& row : rows) {
        names.emplace_back(row.name);
        what += fmt::format("{}{}: {}", what.empty() ? "" : "; ", row.name, row.what);
    }
    app.add_option(flag, text, what)->check(CLI::IsMember(names));
}

/// What the reference integrators have no use for is refused rather than passed over.
void check_fits_integrator(const CLI::App& given, const RenderTexts& t) {
    if (t.integrator == "sppm") return;
    const auto refuse = [&](const std::string& flag) {
        const bool counts_paths = flag == "--photons-per-pass";
        if (given.count(flag) == 0 || (counts_paths && t.integrator == "light")) return;
        throw Error({flag}, "has no meaning with --integrator " + t.integrator, "leave it out");
    };
    for (const char* flag :
         {"--photon-sampler", "--mode", "--replica-exchange", "--mutation-size",
          "--target-acceptance", "--direct", "--ris", "--photons-per-pass", "--radius",
          "--radius-pixels", "--indirect-radius", "--alpha", "--aovs", "--light-group"})
        refuse(flag);
    for (const AdaptivePart& part : kAdaptiveParts) refuse(flag_of(part));
}

/// Aovs that no output can hold are refused: they would be lost.
void check_layers_fit(const CLI::App& given, const RenderOptions& o) {
    if (o.outputs.empty() || !o.snapshots.empty() ||
        !std::all_of(o.outputs.begin(), o.outputs.end(), loses_aovs))
        return;
    for (const char* flag : {"--aovs", "--light-group"})
        if (given.count(flag) > 0)
            throw Error({flag}, "a .png holds no AOVs", "add an output that does: -o FILE.exr");
}

void add_method_flags(CLI::App& app, RenderOptions& o, RenderTexts& t) {
    add_choice(app, "--integrator", t.integrator, kIntegrators);
    add_choice(app, "--photon-sampler", t.sampler, kPhotonSamplers);
    add_adaptive_flags(app, t.adaptive);
    add_paper_flags(app, t.paper);
    app.add_option("--direct", t.direct,
                   "Who brings direct light: sampled, or photons (default sampled; paper photons)")
        ->check(CLI::IsMember({"sampled", "photons"}));
    app.add_option("--ris", t.ris,
                   "Direct light: auto: resampled importance sampling of several candidates; off: "
                   "one sample")
        ->check(CLI::IsMember({"auto", "off"}));
    app.add_option(
           "--energy-compensation", t.energy_compensation,
           "on: rough metals and glass give back what is lost between their facets (default off)")
        ->check(CLI::IsMember({"on", "off"}));
    app.add_option(
           "--photons-per-pass", o.settings.photon.paths_per_pass,
           "Photon paths per pass (default max(200000, 2 a pixel), then see --photon-budget; "
           "paper 200000)")
        ->check(whole(1, 1 << 30));
    CLI::Option* const in_pixels =
        app.add_option("--radius-pixels", o.settings.camera.radius_pixels,
                       "First radius in pixel footprints (default 2, less in pictures of fewer "
                       "than 512 pixels a side; paper 2)")
            ->check(between(1e-3, 1e3));
    app.add_option("--radius", o.settings.camera.radius, "First radius in scene units instead")
        ->check(between(1e-30, 1e30))
        ->excludes(in_pixels);
    app.add_option("--indirect-radius", o.settings.camera.indirect_radius,
                   "Radius for photons that a rough surface has scattered, over that for others "
                   "(default 2 to 3.1, more in pictures of more than 512 pixels a side; "
                   "less where a radius is given; paper 1)")
        ->check(between(1, 100));
    app.add_option("--alpha", o.settings.alpha, "Radius reduction, 0 to 1 (default 2/3; paper .7)")
        ->check(between(1e-6, 1 - 1e-6));
    app.add_option("--max-depth", o.max_depth,
                   "Scattering events on a path, camera and light subpaths together (default: the "
                   "scene's, or 64)")
        ->check(whole(1, 10000));
    app.add_option("--seed", t.seed, "Random seed (default 0)");
}

void add_stop_flags(CLI::App& app, RenderTexts& t) {
    app.add_option("--passes,--spp", t.passes, "End after this many passes")
        ->check(whole(1, 1 << 30));
    app.add_option("--time", t.time,
                   "End after this time of rendering: 60s, 5m, 2h. Reading the scene does not "
                   "count; all rendering before --resume does");
    app.add_option("--cpu-time", t.cpu_time,
                   "The same of processor time, all threads together: for comparisons");
    app.add_option("--target-error", t.target_error,
                   "End when the noise of 95% of the blocks and the bias together come to this "
                   "relative error (default 2%, or after 10m, where no end is given)");
    add_error_flags(app, t.error);
    app.add_option("--pass-range", t.pass_range, "Render passes a to b - 1 only: a:b");
}

void add_picture_flags(CLI::App& app, RenderOptions& o, RenderTexts& t) {
    app.add_option("--resolution", t.resolution, "Picture size instead of the scene's: WxH");
    CLI::Option* const crop =
        app.add_option("--crop", t.crop, "Render only these pixels: x0,x1,y0,y1");
    app.add_option("--cropwindow", t.crop_window,
                   "The same as fractions of the picture, from 0 to 1, as pbrt has them")
        ->excludes(crop);
    app.add_option(
        "--aovs", t.aovs,
        "AOVs, as EXR layers: direct,caustic,indirect,emission,albedo,normal,depth,samples");
    app.add_option(
           "--light-group", t.light_groups,
           "Light group NAME: an EXR layer for some lights alone, by their numbers in sunfleck "
           "info "
           "--lights: NAME=1,3-5; may be repeated. each: a group per light, light1, light2 ...")
        ->allow_extra_args(false);
    app.add_option("--exposure", o.exposure, "Stops for PNG (default 0)")
        ->check(between(-100, 100));
}

void add_run_flags(CLI::App& app, RenderOptions& o, RenderTexts& t) {
    app.add_option("--nthreads", o.threads, "Threads (default: all)")->check(whole(1, 4096));
    app.add_option("--memory-limit", t.memory_limit,
                   "Refuse a render that would need more memory: 512M, 4G (default: what the "
                   "machine, its control group and ulimit -v leave)");
    app.add_option("--isa", o.isa, "avx2 (default; same bytes on every such machine), or native")
        ->check(CLI::IsMember({"avx2", "native"}));
    app.add_option("--stats", o.stats, "Write statistics as JSON");
    app.add_option(
        "--snapshots", o.snapshots,
        "Also write picture and statistics to this folder after 1, 2, 4, 8 ... passes and "
        "at the end");
    auto* const checkpoint = app.add_option(
        "--checkpoint", o.checkpoint, "Keep the render so far in this file, to --resume from");
    app.add_option("--every", t.every, "Time between checkpoints (default 60s)")->needs(checkpoint);
    app.add_option("--resume", o.resume,
                   "Go on from this checkpoint of the same render; limits may be others");
    CLI::Option* const level =
        app.add_option("--log-level", t.log_level,
                       "quiet, warning, or info (default: notes and a progress line, too)")
            ->check(CLI::IsMember({"quiet", "warning", "info"}));
    app.add_flag("--quiet", t.quiet, "The same as --log-level quiet")->excludes(level);
}

}  // namespace

void add_render_flags(CLI::App& app, RenderOptions& o, RenderTexts& t) {
    app.add_option("SCENE", o.scene, "Scene file (pbrt-v4)")->required();
    app.add_option("-o,--output,--outfile", o.outputs,
                   "Output file: .exr, .png, .film; may be repeated (default: the scene's name for "
                   "it, .exr)")
        ->allow_extra_args(false);
    add_method_flags(app, o, t);
    add_stop_flags(app, t);
    add_picture_flags(app, o, t);
    add_run_flags(app, o, t);
}

void finish_render(const CLI::App& given, const RenderTexts& t, RenderOptions& o) {
    check_fits_integrator(given, t);
    // One of the names of each table: checked.
    o.settings.integrator = row_named(kIntegrators, t.integrator)->integrator;
    o.settings.photon.sampler = row_named(kPhotonSamplers, t.sampler)->sampler;
    o.settings.transport.direct =
        t.direct == "photons" ? DirectLight::photons : DirectLight::sampled;
    o.settings.camera.ris = t.ris != "off";
    o.settings.energy_compensation = t.energy_compensation == "on";
    if (!t.seed.empty()) o.settings.seed = read_seed(t.seed, "--seed");
    if (t.quiet || t.log_level == "quiet") o.log = LogLevel::quiet;
    if (t.log_level == "warning") o.log = LogLevel::warning;
    if (!t.resolution.empty()) o.resolution = read_size(t.resolution, "--resolution");
    if (!t.crop.empty()) o.crop = read_crop(t.crop, "--crop");
    if (!t.crop_window.empty()) o.crop_window = read_crop_window(t.crop_window, "--cropwindow");
    o.settings.aovs = read_aovs(t.aovs, "--aovs");
    if (!t.time.empty()) o.stop.seconds = read_duration(t.time, "--time");
    for (const char* flag : {"--checkpoint", "--resume"})
        if (given.count(flag) > 0 && given[flag]->as<std::string>().empty())
            throw Error({flag}, "the file has no name", "name one");
    if (!t.cpu_time.empty()) o.stop.cpu_seconds = read_duration(t.cpu_time, "--cpu-time");
    if (!t.memory_limit.empty()) o.memory_limit = read_bytes(t.memory_limit, "--memory-limit");
    if (!t.every.empty()) o.checkpoint_seconds = read_duration(t.every, "--every");
    if (!t.target_error.empty()) o.stop.target_error = read_share(t.target_error, "--target-error");
    if (t.passes) o.stop.end_pass = *t.passes;
    if (!t.pass_range.empty()) {
        if (t.passes) throw Error({"--pass-range"}, "given together with --passes", "give one");
        read_pass_range(t.pass_range, "--pass-range", o.stop);
    }
    o.ends_by_default =
        !o.stop.end_pass && !o.stop.seconds && !o.stop.cpu_seconds && !o.stop.target_error;
    if (o.ends_by_default) {
        o.stop.target_error = 0.02;
        o.stop.seconds = 600;
    }
    finish_paper(given, t.paper, o);
    finish_adaptive(given, t.adaptive, o.settings.photon);
    if (given.count("--ris") > 0 && o.settings.transport.direct == DirectLight::photons)
        throw Error({"--ris"}, "photons bring direct light: none is sampled", "leave it out");
    o.light_groups = read_light_groups(t.light_groups, o.settings.photon.sampler);
    finish_error(given, t.error, o);
    check_layers_fit(given, o);
}

}  // namespace sunfleck::engine
