// All commands: which one was given, and with what.
#include "apps/cli/command_line.h"

#include "apps/cli/command_flags.h"
#include "apps/cli/manual.h"
#include "apps/cli/picture_flags.h"
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
        app_.formatter(formatter_);
        add_render_flags(*render_app_, render_, flags_);
        add_info_flags(*info_app_, info_);
        add_scene_flags(*scene_app_, scene_);
        add_convert_flags(*convert_app_, convert_);
        add_merge_flags(*merge_app_, merge_, flags_);
        add_relight_flags(*relight_app_, relight_, flags_);
        add_view_flags(*view_app_, view_, flags_);
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
            if (app_.get_subcommands().empty())
                throw Error({"sunfleck"},
                            rest.empty() ? "no command is given"
                                         : "unknown command \"" + rest.front() + "\"",
                            "use one of " + names_of_commands() + "; " + help());
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
        } else if (convert_app_->parsed()) {
            options.convert = convert_;
        } else if (merge_app_->parsed()) {
            const RenderRequest request = flags_.finish();
            check_picture_flags(*merge_app_, merge_.outputs);
            merge_.exposure = request.exposure.value_or(Exposure());
            merge_.files = request.files;
            merge_.extrapolate = request.stop.error_terms.extrapolated;
            options.merge = merge_;
        } else if (relight_app_->parsed()) {
            const RenderRequest request = flags_.finish();
            check_picture_flags(*relight_app_, relight_.outputs);
            relight_.exposure = request.exposure.value_or(Exposure());
            relight_.files = request.files;
            options.relight = relight_;
        } else if (view_app_->parsed()) {
            const RenderRequest request = flags_.finish();
            view_.exposure = request.exposure.value_or(Exposure());
            view_.transform = request.files.transform;
            options.view = view_;
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

    /// @param examples  lines of the help and of the man page.
    CLI::App* add_command(const char* name, const char* what, const char* examples) {
        CLI::App* const app = app_.add_subcommand(name, what);
        app->formatter(formatter_);
        app->group("Commands");
        app->footer("Examples:\n" + std::string(examples));
        return app;
    }

    std::shared_ptr<WrappedHelp> formatter_ = std::make_shared<WrappedHelp>();
    CLI::App app_{"Renderer for caustics, sun through windows and small gaps", "sunfleck"};
    CLI::App* render_app_ =
        add_command("render", "Render a scene",
                    "  sunfleck render scene.pbrt -o scene.exr -o scene.png\n"
                    "  sunfleck render scene.pbrt --time 8h --checkpoint scene.ckpt\n"
                    "  sunfleck render scene.pbrt --light-group sun=1 --light-group lamps=2-5");
    CLI::App* info_app_ =
        add_command("info", "Say what a scene file holds", "  sunfleck info scene.pbrt --lights");
    CLI::App* scene_app_ =
        add_command("scene", "Write one of Sunfleck's own scenes; without NAME, list them",
                    "  sunfleck scene cognac-0 -o scenes");
    CLI::App* convert_app_ =
        add_command("convert", "Write a scene of any format as a pbrt-v4 scene",
                    "  sunfleck convert lamp.glb -o lamp.pbrt");
    CLI::App* merge_app_ =
        add_command("merge", "Add up pass ranges of one render",
                    "  sunfleck merge a.film b.film -o scene.exr --stats scene.json");
    CLI::App* relight_app_ =
        add_command("relight", "Dim or brighten lights of a picture that has them apart",
                    "  sunfleck relight scene.exr sun=0.3 lamps=1,0.8,0.6 -o dim.png");
    CLI::App* view_app_ = add_command("view", "Show a picture in a browser, with all its layers",
                                      "  sunfleck view scene.exr --open");
    CLI::App* compare_app_ =
        add_command("compare", "Measure pictures against a reference, and show them",
                    "  sunfleck compare reference.exr a.exr b.exr --report pictures.html");
    CLI::App* experiment_app_ =
        add_command("experiment", "Make the paper's figures and tables; without NAMES, list them",
                    "  sunfleck experiment all --minutes 1 -o run");
    CLI::App* completion_app_ =
        add_command("completion", "Print what lets a shell complete commands and flags",
                    "  source <(sunfleck completion bash)");
    CLI::App* manual_app_ = add_command("manual", "Write man pages, and completion for all shells",
                                        "  sunfleck manual /usr/local/share");
    RenderOptions render_;
    RenderFlags flags_;  // of the command that is given: render, merge, relight or view
    InfoOptions info_;
    SceneOptions scene_;
    ConvertOptions convert_;
    MergeOptions merge_;
    RelightOptions relight_;
    ViewOptions view_;
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
