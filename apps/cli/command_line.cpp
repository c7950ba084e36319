// The commands and their flags: each command's rows are here, or in a file of their own.
#include "apps/cli/command_line.h"

#include "apps/cli/experiment_options.h"
#include "apps/cli/number_check.h"
#include "apps/cli/renamed_flags.h"
#include "apps/cli/render_options.h"
#include "apps/cli/values.h"
#include "sunfleck/error.h"

#include <CLI/CLI.hpp>

namespace sunfleck::engine {
namespace {

void add_merge(CLI::App& app, MergeOptions& o, ErrorTexts& t) {
    app.add_option("FILES", o.inputs, ".film files")->required();
    app.add_option("-o,--output", o.outputs, ".exr, .png, .film; may be repeated")
        ->allow_extra_args(false)
        ->required();
    app.add_option("--exposure", o.exposure, "Stops for PNG (default 0)")
        ->check(between(-100, 100));
    add_extrapolate_flag(app, t);
    app.add_option("--stats", o.stats, "Write statistics as JSON");
}

void add_relight(CLI::App& app, RelightOptions& o, std::vector<std::string>& factors) {
    app.add_option("PICTURE", o.picture, "EXR picture rendered with --light-group")->required();
    app.add_option("FACTORS", factors,
                   "Factor of a light group: NAME=0.5, or per channel: NAME=1,0.8,0.6")
        ->required();
    app.add_option("-o,--output", o.outputs, ".exr, .png; may be repeated")
        ->allow_extra_args(false)
        ->required();
    app.add_option("--exposure", o.exposure, "Stops for PNG (default 0)")
        ->check(between(-100, 100));
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

void add_info(CLI::App& app, InfoOptions& o) {
    auto* const scene = app.add_option("SCENE", o.scene, "Scene file");
    app.add_flag("--lights", o.lights, "Also each light, by its number")->needs(scene);
    app.add_flag("--words", o.words, "Instead: all words of the language, as Markdown")
        ->excludes(scene);
}

void add_scene(CLI::App& app, SceneOptions& o) {
    app.add_option("NAME", o.name, "Its name");
    app.add_option("-o,--output", o.folder, "Folder to write to (default .)");
    app.add_flag("--force", o.force, "Replace files there that differ");
}

/// All commands; one of them is given.
class CommandLine {
public:
    CommandLine() {
        app_.set_version_flag("--version", "sunfleck " SUNFLECK_VERSION);
        app_.require_subcommand(1);
        add_render_flags(*render_app_, render_, render_texts_);
        add_info(*info_app_, info_);
        add_scene(*scene_app_, scene_);
        add_merge(*merge_app_, merge_, merge_texts_);
        add_relight(*relight_app_, relight_, factors_);
        add_compare(*compare_app_, compare_);
        add_experiment_flags(*experiment_app_, experiment_, experiment_texts_);
    }

    /// @return false where help or the version was asked for, and has been printed.
    bool parse(int count, const char* const* words) {
        try {
            app_.parse(count, words);
        } catch (const CLI::ExtrasError&) {
            std::vector<std::string> rest = app_.remaining(true);
            if (rest.size() > 1 && rest.front() == "--") rest.erase(rest.begin());
            if (const std::string now(name_now(rest.front())); !now.empty())
                throw Error({"sunfleck"}, "\"" + rest.front() + "\" has another name now",
                            "write " + now);
            throw Error({"sunfleck"}, "unknown flag or word \"" + rest.front() + "\"", help());
        } catch (const CLI::RequiredError& fault) {
            const std::vector<std::string> rest = app_.remaining();
            if (app_.get_subcommands().empty() && !rest.empty())
                throw Error({"sunfleck"}, "unknown command \"" + rest.front() + "\"",
                            "use render, info, scene, merge, relight, compare or experiment");
            throw Error({"sunfleck"}, fault.what(), help());
        } catch (const CLI::ParseError& fault) {
            if (fault.get_exit_code() != 0) throw Error({"sunfleck"}, fault.what(), help());
            app_.exit(fault);
            return false;
        }
        return true;
    }

    /// What was given. @param words  as for parse().
    Options finish(int count, const char* const* words) {
        Options options;
        if (render_app_->parsed()) {
            finish_render(*render_app_, render_texts_, render_);
            for (int i = 1; i < count; ++i)
                render_.command += std::string(i > 1 ? " " : "") + words[i];
            options.render = render_;
        } else if (info_app_->parsed()) {
            if (info_.scene.empty() && !info_.words)
                throw Error({"sunfleck info"}, "SCENE is required",
                            "name a scene file, or --words");
            options.info = info_;
        } else if (scene_app_->parsed()) {
            options.scene = scene_;
        } else if (merge_app_->parsed()) {
            merge_.extrapolate = merge_texts_.extrapolate == "on";
            options.merge = merge_;
        } else if (relight_app_->parsed()) {
            for (const std::string& factor : factors_)
                relight_.factors.push_back(read_factor(factor));
            options.relight = relight_;
        } else if (experiment_app_->parsed()) {
            finish_experiment(experiment_texts_, experiment_);
            options.experiment = experiment_;
        } else {
            options.compare = compare_;
        }
        return options;
    }

private:
    /// Where to read on: of the command that was given.
    std::string help() const {
        const auto given = app_.get_subcommands();
        return "see sunfleck " + (given.empty() ? "" : given.front()->get_name() + " ") + "--help";
    }

    CLI::App app_{"Sunfleck: a renderer for caustics, sun through windows and small gaps."};
    CLI::App* render_app_ = app_.add_subcommand("render", "Render a scene");
    CLI::App* info_app_ = app_.add_subcommand("info", "Say what a scene file holds");
    CLI::App* scene_app_ =
        app_.add_subcommand("scene", "Write one of Sunfleck's own scenes; without NAME, list them");
    CLI::App* merge_app_ = app_.add_subcommand("merge", "Add up pass ranges of one render");
    CLI::App* relight_app_ =
        app_.add_subcommand("relight", "Dim or brighten lights of a picture that has them apart");
    CLI::App* compare_app_ =
        app_.add_subcommand("compare", "Measure pictures against a reference, and show them");
    CLI::App* experiment_app_ = app_.add_subcommand(
        "experiment", "Make the paper's figures and tables; without NAMES, list them");
    RenderOptions render_;
    RenderTexts render_texts_;
    InfoOptions info_;
    SceneOptions scene_;
    MergeOptions merge_;
    ErrorTexts merge_texts_;
    RelightOptions relight_;
    std::vector<std::string> factors_;
    CompareOptions compare_;
    ExperimentOptions experiment_;
    ExperimentTexts experiment_texts_;
};

}  // namespace

std::optional<Options> read_options(int count, const char* const* words) {
    CommandLine line;
    if (!line.parse(count, words)) return {};
    return line.finish(count, words);
}

}  // namespace sunfleck::engine
