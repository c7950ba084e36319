// The flags of all commands but `sunfleck render`.
#include "apps/cli/command_flags.h"

#include "apps/cli/flag_rows.h"
#include "apps/cli/picture_flags.h"
#include "core/named_rows.h"
#include "experiment/figure.h"
#include "procedural/scenes.h"
#include "sunfleck/error.h"

#include <filesystem>

namespace sunfleck::engine {
namespace {

/// An output that may be repeated.
void add_outputs(CLI::App& app, std::vector<std::string>& outputs, const char* formats) {
    app.add_option("-o,--output", outputs,
                   "Output file: " + std::string(formats) + "; may be repeated")
        ->type_name("FILE")
        ->allow_extra_args(false)
        ->required();
}

OtherPicture read_other(const std::string& text, const std::string& flag) {
    const std::size_t first = text.find('=');
    const std::size_t second = first == std::string::npos ? first : text.find('=', first + 1);
    if (second == std::string::npos || first == 0 || second == first + 1 ||
        second + 1 == text.size())
        throw Error({flag}, "\"" + text + "\" is no SCENE=LABEL=FILE",
                    "write for instance room=pbrt=room-pbrt.exr");
    return {text.substr(0, first), text.substr(first + 1, second - first - 1),
            text.substr(second + 1)};
}

/// Minutes, or a time with its unit.
double read_minutes(const std::string& text, const std::string& flag) {
    const bool plain = text.find_first_not_of("0123456789.") == std::string::npos;
    return read_duration(plain ? text + "m" : text, flag);
}

const Shell* read_shell(const std::string& text, const std::string& flag) {
    if (const Shell* const shell = row_named(kShells, text)) return shell;
    throw Error({flag}, "does not take \"" + text + "\"", "use " + form_of_names(kShells));
}

/// A file whose name ends in .pbrt.
std::string read_pbrt_name(const std::string& text, const std::string& flag) {
    const std::filesystem::path path(text);
    if (path.extension() == ".pbrt") return text;
    throw Error({flag}, "\"" + text + "\" is no name of a .pbrt file",
                "write for instance cup.pbrt");
}

}  // namespace

void add_merge_flags(CLI::App& app, MergeOptions& o, RenderFlags& flags) {
    app.add_option("FILES", o.inputs, ".film files")->required()->type_name("FILE");
    add_outputs(app, o.outputs, ".exr, .png, .jpg, .film");
    add_flag(app, render_flag("--extrapolate"), flags);
    add_picture_flags(app, flags);
    app.add_option("--stats", o.stats, "Write statistics as JSON")->type_name("FILE");
}

void add_relight_flags(CLI::App& app, RelightOptions& o, RenderFlags& flags) {
    app.add_option("PICTURE", o.picture, "EXR picture rendered with --light-group")
        ->required()
        ->type_name("FILE");
    add_values(app,
               {.name = "FACTORS",
                .form = "NAME=FACTOR",
                .help = "Factor of a light group: NAME=0.5, or per channel: NAME=1,0.8,0.6"},
               o.factors, read_factor)
        ->required();
    add_outputs(app, o.outputs, ".exr, .png, .jpg");
    add_picture_flags(app, flags);
}

void add_view_flags(CLI::App& app, ViewOptions& o, RenderFlags& flags) {
    app.add_option("PICTURE", o.picture, "EXR picture")->required()->type_name("FILE");
    app.add_flag("--open", o.opens, "Also open its address in the browser");
    app.add_option("--against", o.against, "An EXR picture to compare with, by a wipe")
        ->type_name("FILE");
    app.add_option("--host", o.host,
                   "Serve the page at this address, or 0.0.0.0, not to this machine alone")
        ->type_name("ADDRESS");
    add_page_flags(app, flags);
}

void add_compare_flags(CLI::App& app, CompareOptions& o) {
    app.add_option("REF", o.reference, "The reference: a picture, [LABEL=]FILE")
        ->required()
        ->type_name("FILE");
    app.add_option("PICTURES", o.inputs,
                   "Pictures, [LABEL=]FILE, or folders of snapshots, [LABEL=]FOLDER")
        ->required()
        ->type_name("FILE");
    app.add_option("--report", o.report, "Write a page to look at: one .html that needs no network")
        ->type_name("FILE");
    app.add_option("--json", o.json, "Write the numbers as JSON")->type_name("FILE");
}

void add_info_flags(CLI::App& app, InfoOptions& o) {
    auto* const scene = app.add_option("SCENE", o.scene, "Scene file")->type_name("FILE");
    app.add_flag("--lights", o.lights, "Also each light, by its number")->needs(scene);
    app.add_flag("--words", o.words, "Instead: all words of the language, as Markdown")
        ->excludes(scene);
    add_request_flags(app, o.scene_request);
}

void add_scene_flags(CLI::App& app, SceneOptions& o) {
    app.add_option("NAME", o.name, "Its name")
        ->type_name(form_of_names(procedural_scenes()))
        ->option_text("NAME");
    app.add_option("-o,--output", o.folder, "Folder to write to (default .)")->type_name("FOLDER");
    app.add_flag("--force", o.force, "Replace files there that differ");
}

void add_convert_flags(CLI::App& app, ConvertOptions& o) {
    add_value(app, {.name = "SCENE", .form = "FILE", .help = "Scene file"}, o.scene, read_name)
        ->required();
    add_value(app,
              {.name = "-o,--output",
               .form = "FILE",
               .help = "The .pbrt file to write; a folder NAME-files beside it has meshes and "
                       "pictures"},
              o.output, read_pbrt_name)
        ->required();
    app.add_flag("--force", o.force, "Replace files there that differ");
    add_request_flags(app, o.scene_request);
}

void add_completion_flags(CLI::App& app, ManualOptions& o) {
    add_value(app,
              {.name = "SHELL", .form = form_of_names(kShells), .help = "Shell that is to read it"},
              o.shell, read_shell)
        ->required();
}

void add_manual_flags(CLI::App& app, ManualOptions& o) {
    app.add_option("FOLDER", o.folder, "Folder such as /usr/local/share")
        ->required()
        ->type_name("FOLDER");
}

void add_experiment_flags(CLI::App& app, ExperimentOptions& o) {
    RunSettings& run = o.run;
    app.add_option("NAMES", o.names,
                   "Figures: table1, fig1, fig5 to fig13, or all; none: list them")
        ->type_name(form_of_names(figures()) + "|all")
        ->option_text("NAME ...");
    app.add_option("-o,--output", run.folder,
                   "Folder of the run; one begun before goes on (default experiment)")
        ->type_name("FOLDER");
    add_value(app,
              {.name = "--minutes",
               .form = "N",
               .help = "Processor minutes of each render, of all threads together; or 30s, 2h "
                       "(default 1)"},
              run.cpu_seconds, read_minutes);
    add_value(
        app, {.name = "--passes", .form = "N", .help = "Passes of each render, instead of minutes"},
        run.passes, whole_from(1, 1 << 20));
    add_value(app, {.name = "--seeds", .form = "N", .help = "Renders of each method (default 5)"},
              run.seeds, whole_from(1, 1000));
    add_value(app,
              {.name = "--scale",
               .form = "X",
               .help = "Sides of pictures, of full size (0.02 to 1; default 1)"},
              run.scale, number_from(0.02, 1));
    add_value(app,
              {.name = "--reference-budget",
               .form = "X",
               .help = "Length of references, in renders (default 10)"},
              run.reference_budget, number_from(1, 1e4));
    add_value(app, {.name = "--nthreads", .form = "N", .help = "Threads (1 to 4096; default all)"},
              run.threads, whole_from(1, 4096));
    add_values(app,
               {.name = "--other",
                .form = "SCENE=LABEL=FILE",
                .help = "Another renderer's picture, shown and measured; may be repeated"},
               run.others, read_other);
}

void check_experiment(const CLI::App& given) {
    if (given.count("--minutes") > 0 && given.count("--passes") > 0)
        throw Error({"--minutes"}, "given together with --passes", "give one");
}

}  // namespace sunfleck::engine
