// `sunfleck render`: scene in, pictures out.
#include "apps/cli/commands.h"
#include "apps/cli/display_link.h"
#include "apps/cli/live_view.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/progress.h"
#include "apps/cli/progress_text.h"
#include "apps/cli/render_answers.h"
#include "apps/cli/render_notes.h"
#include "apps/cli/render_setup.h"
#include "apps/cli/snapshots.h"
#include "apps/cli/steered_render.h"
#include "apps/cli/together.h"
#include "core/parallel.h"
#include "core/stopwatch.h"
#include "core/thread_trial.h"
#include "image/atomic_file.h"
#include "import/load.h"
#include "ranks/shared_interval.h"
#include "render/progressive.h"
#include "stats/remarks.h"
#include "stats/stats.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <utility>

namespace sunfleck::engine {
namespace {

Exposure exposure_of(const RenderOptions& options) {
    return options.request.exposure.value_or(usual_exposure(options.scene));
}

OutputOptions output_options(const RenderOptions& options) {
    return {.exposure = exposure_of(options),
            .extrapolate = options.request.stop.error_terms.extrapolated,
            .files = options.request.files};
}

/// Returns what the flags ask of the page.
LiveViewing viewing_of(const RenderOptions& options) {
    return {.name = std::filesystem::path(options.scene).filename().string(),
            .exposure = exposure_of(options),
            .transform = options.request.files.transform,
            .earlier = options.view_against,
            .host = options.view_host,
            .extrapolates = options.request.stop.error_terms.extrapolated,
            .opens = options.view_open,
            .stays = options.view_stay,
            .log = options.log};
}

void print_lines(const std::vector<std::string>& lines, LogLevel log) {
    if (log == LogLevel::quiet) return;
    for (const std::string& line : lines) say(line);
}

void set_times(RunFacts& facts, const RenderState& state) {
    facts.seconds = state.seconds;
    facts.radius_factor = state.radius_factor;
    facts.total_seconds = facts.load_seconds + state.total_seconds;
    facts.cpu_seconds = state.cpu_seconds;
}

/// Files that a render keeps up to date while it runs, and what went wrong with them.
struct KeptFiles {
    CheckpointKeeper checkpoints;
    DeferredError snapshots;  // one that is missing is missed, whatever follows

    explicit KeptFiles(const RenderOptions& options)
        : checkpoints(options), snapshots(options.log) {}
};

void keep_snapshot(const RenderSetup& setup, const RenderState& so_far, DeferredError& fault,
                   RunFacts& facts) {
    set_times(facts, so_far);
    InterruptGuard::finish_first([&] {
        fault.attempt([&] {
            write_snapshot(setup.options.snapshots, so_far.film, facts,
                           output_options(setup.options));
        });
    });
}

RenderStep step_of(const Progress& progress) {
    if (progress.passes > 0) return RenderStep::later_pass;
    return progress.is_learning ? RenderStep::learning : RenderStep::first_pass;
}

/// Where a render is watched; null: not there.
struct Watchers {
    LiveView* view = nullptr;
    DisplayLink* display = nullptr;
};

void add_watchers(RenderHooks& hooks, const Watchers& watchers) {
    const auto [view, display] = watchers;
    if (view == nullptr && display == nullptr) return;
    hooks.watch = [view, display](const Film& film) {
        if (view != nullptr) view->show(film);
        if (display != nullptr) display->show(film);
    };
    hooks.preview = [view, display](Picture picture) {
        if (display != nullptr) display->preview(picture);
        if (view != nullptr) view->preview(std::move(picture));
    };
}

/// What rank 0 does while it renders: a progress line, and if wanted snapshots, checkpoints and a
/// page or a display server.
RenderHooks hooks_of(const RenderSetup& setup, ProgressLine& line, const Watchers& watchers,
                     KeptFiles& kept, RunFacts& facts) {
    const RenderOptions& options = setup.options;
    RenderHooks hooks;
    hooks.report = [&, view = watchers.view](const Progress& p) {
        InterruptGuard::set_answer(answer_while(step_of(p), options));
        line.show(p);
        if (view != nullptr) view->report(p);
    };
    add_watchers(hooks, watchers);
    hooks.interrupted = &InterruptGuard::interrupted();
    if (!options.snapshots.empty())
        hooks.snapshot = [&](const RenderResult& so_far) {
            keep_snapshot(setup, so_far, kept.snapshots, facts);
        };
    if (!options.checkpoint.empty())
        hooks.save = [&](const RenderState& state) { kept.checkpoints.save(setup.origin, state); };
    hooks.save_every = options.checkpoint_seconds;
    return hooks;
}

/// Returns the mattes that are asked for.
std::optional<Mattes> mattes_of(const RenderSetup& setup) {
    if (setup.options.mattes.kinds.empty()) return {};
    return make_mattes(setup.scene, setup.options.mattes);
}

/// Tells of pixels whose mattes are not complete.
void tell_crowded(const std::optional<Mattes>& mattes, LogLevel log) {
    if (!mattes || mattes->crowded == 0) return;
    print_lines({fmt::format("mattes: {} pixels show more than {} objects or materials; those of "
                             "the least coverage are left out there",
                             mattes->crowded, kMatteIds)},
                log);
}

/// Pictures, remarks, statistics, and what each picture is.
/// @param line  is ended when all pictures are written: a terminal may hold it up.
void write_all(const RenderSetup& setup, const RenderResult& result, RunFacts& facts,
               std::optional<ProgressLine>& line) {
    const RenderOptions& options = setup.options;
    DeferredError faults(LogLevel::quiet);  // thrown when all is tried
    InterruptGuard::set_answer(answer_while(RenderStep::writing, options));
    WrittenOutputs written;
    std::optional<Mattes> mattes;
    InterruptGuard::finish_first([&] {
        faults.attempt([&] { mattes = mattes_of(setup); });
        OutputOptions output = output_options(options);
        output.mattes = mattes ? &*mattes : nullptr;
        written = write_outputs(setup.outputs, result.film, output, faults);
    });
    line.reset();
    tell_crowded(mattes, options.log);
    const std::vector<std::string> remarks = remarks_after(setup.job, result);
    print_lines(remarks, options.log);
    facts.warnings.insert(facts.warnings.end(), remarks.begin(), remarks.end());
    set_times(facts, result);
    if (!options.stats.empty()) {
        const std::string json = stats_json(result.film, facts);
        const auto write = [&] { write_file(options.stats, json); };
        InterruptGuard::finish_first([&] { faults.attempt(write); });
    }
    const std::string state =
        state_text(result.film.pass_count(), result.total_seconds,
                   target_error(result.film, options.request.stop.error_terms));
    for (std::string& file : written.files) file += ": " + state;
    if (written.found_exposure)
        written.files.push_back(
            fmt::format("exposure of the {1}: {0:+.1f} stops (--exposure {0:.1f})",
                        *written.found_exposure, written.exposed_ending));
    if (options.log == LogLevel::info) print_lines(written.files, options.log);
    faults.finish();
}

/// A rank that writes nothing.
int help_render(const RenderSetup& setup, const Ranks& ranks, LogLevel log) {
    for (const std::string& line : machine_warnings(setup.options.request.isa))
        print_lines({fmt::format("rank {}: {}", ranks.rank, line)}, log);
    RenderHooks hooks;
    hooks.interrupted = &InterruptGuard::interrupted();
    render(setup.job, hooks, {}, ranks);
    return 0;
}

}  // namespace

int run_render(const RenderOptions& asked, const Ranks& ranks) {
    const Stopwatch clock;
    const InterruptGuard guard(answer_while(RenderStep::reading, asked));
    const ThreadLimit limit(asked.threads);
    together(ranks, [&] {
        try_threads();
        return true;
    });
    std::optional<ProgressLine> line(std::in_place,
                                     ranks.is_first() && asked.log == LogLevel::info);
    std::optional<LiveView> view;
    if (asked.view && ranks.is_first()) view.emplace(viewing_of(asked));
    const auto display = together(ranks, [&] { return display_link(asked, ranks); });
    const auto setup = together(ranks, [&] { return prepare(options_of(asked, ranks), ranks); });
    together(ranks, [&] {
        check_same_render(ranks, key_of(setup->job));
        return true;
    });
    const RenderOptions& options = setup->options;
    const RenderStep begin = setup->checkpoint ? RenderStep::later_pass : RenderStep::first_pass;
    InterruptGuard::set_answer(answer_while(begin, options));
    const auto claims =
        together(ranks, [&] { return std::make_unique<OutputClaims>(written_files(*setup)); });
    if (!ranks.is_first()) return help_render(*setup, ranks, asked.log);
    RunFacts facts{.scene = options.scene,
                   .command = options.command,
                   .isa = options.request.isa,
                   .threads = thread_count(),
                   .seconds = {},
                   .warnings = remarks_before(setup->job, options.request.isa),
                   .ranks = ranks.size,
                   .error_terms = options.request.stop.error_terms};
    print_lines(facts.warnings, options.log);
    if (options.log == LogLevel::info) print_lines(notes_of(*setup), options.log);
    facts.load_seconds = clock.seconds();

    KeptFiles kept(options);
    std::optional<RenderState> earlier;
    if (setup->checkpoint) earlier = std::move(setup->checkpoint->state);
    if (view) view->begin(*setup, facts.warnings, earlier ? &earlier->film : nullptr);
    if (display) display->begin(key_of(setup->job), earlier ? &earlier->film : nullptr);
    const Watchers watchers{view ? &*view : nullptr, display.get()};
    const RenderHooks hooks = hooks_of(*setup, *line, watchers, kept, facts);
    const RenderResult result = view && ranks.is_alone()
                                    ? render_steered(*setup, hooks, std::move(earlier), *view)
                                    : render(setup->job, hooks, std::move(earlier), ranks);
    if (view) view->show_last(result);
    write_all(*setup, result, facts, line);
    kept.checkpoints.finish();
    kept.snapshots.finish();
    if (display) display->end(result.film);
    if (view) view->end(facts.warnings, [&] { look_aside(*setup, *view); });
    return result.interrupted ? 130 : 0;
}

}  // namespace sunfleck::engine
