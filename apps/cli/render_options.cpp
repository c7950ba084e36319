// The flags that `sunfleck render` has beside those of any render.
#include "apps/cli/render_options.h"

#include "apps/cli/flag_rows.h"
#include "apps/cli/matte_flags.h"
#include "apps/cli/picture_flags.h"
#include "image/picture_file.h"
#include "sunfleck/error.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

LogLevel read_log_level(const std::string& text, const std::string& flag) {
    if (text == "quiet") return LogLevel::quiet;
    if (text == "warning") return LogLevel::warning;
    if (text == "info") return LogLevel::info;
    throw Error({flag}, "does not take \"" + text + "\"", "use quiet, warning or info");
}

void add_file_flags(CLI::App& app, RenderOptions& o) {
    app.add_option("SCENE", o.scene, "Scene file: pbrt-v4, glTF, or a part alone: OBJ, STL, PLY")
        ->required()
        ->type_name("FILE");
    app.add_option("-o,--output,--outfile", o.outputs,
                   "Output file: .exr, .png, .jpg, .film; may be repeated (default the scene's "
                   "name for it, .exr)")
        ->type_name("FILE")
        ->allow_extra_args(false);
    app.add_option("--stats", o.stats, "Write statistics as JSON")->type_name("FILE");
    app.add_option("--snapshots", o.snapshots,
                   "Also write picture and statistics to this folder, after passes 1, 2, 4, 8 and "
                   "so on and at the end, and the newest picture as latest.exr and latest.png")
        ->type_name("FOLDER");
    auto* const checkpoint =
        add_value(app,
                  {.name = "--checkpoint",
                   .form = "FILE",
                   .help = "Keep the render so far in this file, to --resume from"},
                  o.checkpoint, read_name);
    add_value(app,
              {.name = "--every", .form = "TIME", .help = "Time between checkpoints (default 60s)"},
              o.checkpoint_seconds, read_duration)
        ->needs(checkpoint);
    add_value(app,
              {.name = "--resume",
               .form = "FILE",
               .help = "Go on from this checkpoint of the same render; limits may be others"},
              o.resume, read_name);
    for (CLI::Option* option : app.get_options())
        if (option != app.get_help_ptr()) option->group("Files");
}

void add_view_flags(CLI::App& app, RenderOptions& o) {
    CLI::Option* const view =
        app.add_flag("--view", o.view,
                     "Watch the render in a browser on this machine: its address is printed first");
    CLI::Option* const open =
        app.add_flag("--view-open", o.view_open, "Also open that address in the browser");
    CLI::Option* const stay = app.add_flag(
        "--view-stay", o.view_stay, "Also keep the page when the render has ended, until Ctrl+C");
    CLI::Option* const host =
        app.add_option("--view-host", o.view_host,
                       "Serve the page at this address, or 0.0.0.0, not to this machine alone");
    host->type_name("ADDRESS");
    CLI::Option* const against = app.add_option("--view-against", o.view_against,
                                                "A picture to compare with on the page, by a wipe");
    against->type_name("FILE");
    for (CLI::Option* more : {open, stay, host, against}) more->needs(view);
    for (CLI::Option* option : {view, open, stay, host, against}) option->group("View");
    add_value(app,
              {.name = "--display-server",
               .form = "HOST:PORT",
               .help = "Also show the render in tev, which listens there: 127.0.0.1:14158",
               .group = "View"},
              o.display_server, read_display_address);
}

void add_run_flags(CLI::App& app, RenderOptions& o) {
    add_value(app,
              {.name = "--nthreads",
               .form = "N",
               .help = "Threads (1 to 4096; default all)",
               .group = "Run"},
              o.threads, whole_from(1, 4096));
    add_value(app,
              {.name = "--memory-limit",
               .form = "SIZE",
               .help = "Refuse a render that would need more memory: 512M, 4G (default what the "
                       "machine, its control group and ulimit -v leave)",
               .group = "Run"},
              o.memory_limit, read_bytes);
    CLI::Option* const level = add_value(
        app,
        {.name = "--log-level",
         .form = "quiet|warning|info",
         .help = "What is said on standard error beside faults: nothing, warnings, or also "
                 "defaults taken and a progress line (default info)",
         .group = "Run"},
        o.log, read_log_level);
    app.add_flag_callback(
           "--quiet", [&o] { o.log = LogLevel::quiet; }, "The same as --log-level quiet")
        ->excludes(level)
        ->group("Run");
}

/// AOVs that no output can hold are refused: they would be lost.
void check_aovs_fit(const CLI::App& given, const RenderOptions& o) {
    if (o.outputs.empty() || !o.snapshots.empty() ||
        !std::all_of(o.outputs.begin(), o.outputs.end(), loses_aovs))
        return;
    for (const char* flag : {"--aovs", "--light-group"})
        if (given.count(flag) > 0)
            throw Error({flag}, "a .png or .jpg holds no AOVs",
                        "add an output that does: -o FILE.exr");
}

/// Returns names of picture files that the render will write, by their endings.
std::vector<std::string> picture_files(const RenderOptions& o) {
    std::vector<std::string> files = o.outputs;
    if (files.empty()) files.emplace_back("the scene's.exr");
    if (!o.snapshots.empty()) files.insert(files.end(), {"latest.exr", "latest.png"});
    return files;
}

/// Returns the layers that pictures of the render have, or may have once there are error bars.
std::vector<std::string> possible_layers(const RenderRequest& request) {
    constexpr int kMostLights = 64;  // of --light-group each
    std::vector<std::string> layers = {"picture", "error", "bias"};
    for (const AovRow& row : kAovs)
        if (!row.name.empty() && request.settings.aovs.at(static_cast<std::size_t>(row.aov)))
            layers.emplace_back(row.name);
    for (const AskedLightGroup& group : request.light_groups) {
        if (!group.name.empty()) layers.push_back(group.name);
        for (int light = 1; group.name.empty() && light <= kMostLights; ++light)
            layers.push_back("light" + std::to_string(light));
    }
    return layers;
}

}  // namespace

void add_render_flags(CLI::App& app, RenderOptions& o, RenderFlags& flags) {
    add_file_flags(app, o);
    add_request_flags(app, o.scene_request);
    for (const RenderFlag& row : render_flags()) add_flag(app, row, flags);
    add_matte_flags(app, o);
    add_view_flags(app, o);
    add_run_flags(app, o);
}

void finish_render(const CLI::App& given, const RenderFlags& flags, RenderOptions& o) {
    o.request = flags.finish();
    check_aovs_fit(given, o);
    check_mattes(o);
    check_picture_flags(given, picture_files(o), o.view);
    check_half_layers(o.request.files.exr, possible_layers(o.request));
}

}  // namespace sunfleck::engine
