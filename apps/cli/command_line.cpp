// All commands: which one was given, and with what.
#include "apps/cli/command_line.h"

#include "apps/cli/command_flags.h"
#include "apps/cli/manual.h"
#include "apps/cli/render_options.h"
#include "apps/cli/wrapped_help.h"
#include "flags/renamed_flags.h"
#include "sunfleck/error.h"

#include <CLI/CLI.hpp>

namespace sunfleck::engine {
namespace {

/// All commands; one of them is given.
class CommandLine {
public:
    CommandLine() {
        app_.set_version_flag("--version", "sunfleck " SUNFLECK_VERSION);
        app_.require_subcommand(1);
        for (CLI::App* app : app_.get_subcommands([](CLI::App*) { return true; }))
            app->formatter(std::make_shared<WrappedHelp>());
        add_render_flags(*render_app_, render_, flags_);
        add_info_flags(*info_app_, info_);
        add_scene_flags(*scene_app_, scene_);
        add_merge_flags(*merge_app_, merge_, flags_);
        add_relight_flags(*relight_app_, relight_, flags_);
        add_compare_flags(*compare_app_, compare_);
        add_experiment_flags(*experiment_app_, experiment_);
        add_completion_flags(*completion_app_, manual_);
        add_manual_flags(*manual_app_, manual_);
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
                            "use " + names_of_commands());
            throw Error({"sunfleck"}, fault.what(), help());
        } catch (const CLI::ParseError& fault) {
            if (fault.get_exit_code() != 0) throw Error({"sunfleck"}, fault.what(), help());
            app_.exit(fault);
            return false;
        }
        return true;
    }

    /// What was given; nothing where it has been answered. @param words  as for parse().
    std::optional<Options> finish(int count, const char* const* words) {
        Options options;
        if (render_app_->parsed()) {
            finish_render(*render_app_, flags_, render_);
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
            const RenderRequest request = flags_.finish();
            merge_.exposure = request.exposure;
            merge_.extrapolate = request.stop.error_terms.extrapolated;
            options.merge = merge_;
        } else if (relight_app_->parsed()) {
            relight_.exposure = flags_.finish().exposure;
            options.relight = relight_;
        } else if (experiment_app_->parsed()) {
            check_experiment(*experiment_app_);
            options.experiment = experiment_;
        } else if (completion_app_->parsed()) {
            std::fputs(manual_.shell->script(command_tree(app_)).c_str(), stdout);
            return {};
        } else if (manual_app_->parsed()) {
            write_manual(command_tree(app_), manual_.folder);
            return {};
        } else {
            options.compare = compare_;
        }
        return options;
    }

private:
    std::string names_of_commands() const {
        std::string names;
        for (const CLI::App* app : app_.get_subcommands({}))
            names += (names.empty() ? "" : ", ") + app->get_name();
        return names;
    }

    /// Where to read on: of the command that was given.
    std::string help() const {
        const auto given = app_.get_subcommands();
        return "see sunfleck " + (given.empty() ? "" : given.front()->get_name() + " ") + "--help";
    }

    CLI::App app_{"Renderer for caustics, sun through windows and small gaps", "sunfleck"};
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
    CLI::App* completion_app_ =
        app_.add_subcommand("completion", "Print what lets a shell complete commands and flags");
    CLI::App* manual_app_ =
        app_.add_subcommand("manual", "Write man pages, and completion for all shells");
    RenderOptions render_;
    RenderFlags flags_;  // of the command that is given: render, merge or relight
    InfoOptions info_;
    SceneOptions scene_;
    MergeOptions merge_;
    RelightOptions relight_;
    CompareOptions compare_;
    ExperimentOptions experiment_;
    ManualOptions manual_;
};

}  // namespace

std::optional<Options> read_options(int count, const char* const* words) {
    CommandLine line;
    if (!line.parse(count, words)) return {};
    return line.finish(count, words);
}

}  // namespace sunfleck::engine
