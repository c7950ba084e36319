// The commands and their flags: each command's rows are here, or in a file of their own.
#include "apps/cli/options.h"

#include "apps/cli/experiment_options.h"
#include "apps/cli/number_check.h"
#include "apps/cli/render_options.h"
#include "core/error.h"

#include <CLI/CLI.hpp>

namespace sunfleck {
namespace {

void add_merge(CLI::App& app, MergeOptions& o, ErrorTexts& t) {
    app.add_option("FILES", o.inputs, ".film files")->required();
    app.add_option("-o,--output", o.outputs, ".exr, .png, .film; may be repeated")
        ->allow_extra_args(false)
        ->required();
    app.add_option("--exposure", o.exposure, "Stops for PNG")->check(between(-100, 100));
    add_extrapolate_flag(app, t);
    app.add_option("--stats", o.stats, "Write statistics as JSON");
}

void add_relight(CLI::App& app, RelightOptions& o, std::vector<std::string>& factors) {
    app.add_option("PICTURE", o.picture, "EXR picture rendered with --light-layer")->required();
    app.add_option("FACTORS", factors,
                   "How bright a layer's lights are to be: NAME=0.5, or of R, G, B: NAME=1,0.8,0.6")
        ->required();
    app.add_option("-o,--output", o.outputs, ".exr, .png; may be repeated")
        ->allow_extra_args(false)
        ->required();
    app.add_option("--exposure", o.exposure, "Stops for PNG")->check(between(-100, 100));
}

void add_compare(CLI::App& app, CompareOptions& o) {
    app.add_option("REF", o.reference, "The reference: a picture, [LABEL=]FILE")->required();
    app.add_option("PICTURES", o.inputs,
                   "Pictures, [LABEL=]FILE, or folders of snapshots, [LABEL=]FOLDER")
        ->required();
    app.add_option("--report", o.report,
                   "Write a page to look at: one .html that needs no network");
    app.add_option("--json", o.json, "Write the numbers as JSON");
}

}  // namespace

std::optional<Options> read_options(int count, const char* const* words) {
    CLI::App app("Sunfleck: a renderer for caustics, sun through windows and small gaps.");
    app.set_version_flag("--version", "sunfleck " SUNFLECK_VERSION);
    app.require_subcommand(1);
    RenderOptions render;
    RenderTexts texts;
    InfoOptions info;
    SceneOptions scene;
    MergeOptions merge;
    CompareOptions compare;
    CLI::App* const render_app = app.add_subcommand("render", "Render a scene");
    add_render_flags(*render_app, render, texts);
    CLI::App* const info_app = app.add_subcommand("info", "Say what a scene file holds");
    auto* const info_scene = info_app->add_option("SCENE", info.scene, "Scene file");
    info_app->add_flag("--lights", info.lights, "Also each light, by its number")
        ->needs(info_scene);
    info_app->add_flag("--words", info.words, "Instead: all words of the language, as Markdown")
        ->excludes(info_scene);
    CLI::App* const scene_app =
        app.add_subcommand("scene", "Write one of Sunfleck's own scenes; without NAME, list them");
    scene_app->add_option("NAME", scene.name, "Its name");
    scene_app->add_option("-o,--output", scene.folder, "Folder to write to (default .)");
    CLI::App* const merge_app = app.add_subcommand("merge", "Add up pass ranges of one render");
    ErrorTexts merge_texts;
    add_merge(*merge_app, merge, merge_texts);
    RelightOptions relight;
    std::vector<std::string> factors;
    CLI::App* const relight_app =
        app.add_subcommand("relight", "Dim or brighten lights of a picture that has them apart");
    add_relight(*relight_app, relight, factors);
    CLI::App* const compare_app =
        app.add_subcommand("compare", "Measure pictures against a reference, and show them");
    add_compare(*compare_app, compare);
    ExperimentOptions experiment;
    ExperimentTexts experiment_texts;
    CLI::App* const experiment_app = app.add_subcommand(
        "experiment", "Make the paper's figures and tables; without NAMES, list them");
    add_experiment_flags(*experiment_app, experiment, experiment_texts);
    try {
        app.parse(count, words);
    } catch (const CLI::ExtrasError&) {
        throw Error({"sunfleck"}, "unknown flag or word \"" + app.remaining(true).front() + "\"",
                    "see sunfleck --help and sunfleck COMMAND --help");
    } catch (const CLI::RequiredError& fault) {
        const std::vector<std::string> rest = app.remaining();
        if (app.get_subcommands().empty() && !rest.empty())
            throw Error({"sunfleck"}, "unknown command \"" + rest.front() + "\"",
                        "use render, info, scene, merge, relight, compare or experiment");
        throw Error({"sunfleck"}, fault.what(), "see sunfleck --help");
    } catch (const CLI::ParseError& fault) {
        if (fault.get_exit_code() == 0) {
            app.exit(fault);
            return {};
        }
        throw Error({"sunfleck"}, fault.what(), "see sunfleck --help");
    }
    Options options;
    if (render_app->parsed()) {
        finish_render(*render_app, texts, render);
        for (int i = 1; i < count; ++i) render.command += std::string(i > 1 ? " " : "") + words[i];
        options.render = render;
    } else if (info_app->parsed()) {
        if (info.scene.empty() && !info.words)
            throw Error({"sunfleck info"}, "SCENE is required", "name a scene file, or --words");
        options.info = info;
    } else if (scene_app->parsed()) {
        options.scene = scene;
    } else if (merge_app->parsed()) {
        merge.extrapolate = merge_texts.extrapolate == "on";
        options.merge = merge;
    } else if (relight_app->parsed()) {
        for (const std::string& factor : factors) relight.factors.push_back(read_factor(factor));
        options.relight = relight;
    } else if (experiment_app->parsed()) {
        finish_experiment(experiment_texts, experiment);
        options.experiment = experiment;
    } else {
        options.compare = compare;
    }
    return options;
}

}  // namespace sunfleck
