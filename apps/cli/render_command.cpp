// `sunfleck render`: scene in, pictures out.
#include "apps/cli/commands.h"
#include "apps/cli/darkness.h"
#include "apps/cli/image_stats.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/progress.h"
#include "apps/cli/render_answers.h"
#include "apps/cli/render_setup.h"
#include "apps/cli/snapshots.h"
#include "apps/cli/stats.h"
#include "apps/cli/together.h"
#include "core/parallel.h"
#include "core/processor.h"
#include "core/stopwatch.h"
#include "core/thread_trial.h"
#include "image/atomic_file.h"
#include "planning/missing_light.h"
#include "ranks/shared_interval.h"
#include "render/progressive.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <utility>

namespace sunfleck::engine {
namespace {

void print_lines(const std::vector<std::string>& lines, LogLevel log) {
    if (log == LogLevel::quiet) return;
    for (const std::string& line : lines) say(line);
}

const char* const kNoAvx2 =
    "this machine has no AVX2: bytes may differ from those of other machines";

/// What is to be said before the render.
std::vector<std::string> warnings_of(const RenderOptions& options, const Scene& scene) {
    std::vector<std::string> lines;
    for (const auto& entry : scene.warnings().entries()) lines.push_back(entry.line());
    if (options.isa == "avx2" && !cpu_has_avx2()) lines.emplace_back(kNoAvx2);
    if (options.settings.photon.sampler == PhotonSampler::paper)
        lines.emplace_back(
            "sampler paper: its counts are pooled while the view and the radii change, so the "
            "picture is biased until it has converged, and has no error bars; adaptive is not");
    return lines;
}

/// Defaults that the user may want to know of.
std::vector<std::string> notes_of(const RenderSetup& setup) {
    const RenderOptions& options = setup.options;
    std::vector<std::string> lines;
    if (!options.max_depth && !setup.scene.hints().max_depth)
        lines.push_back(fmt::format("maximum depth not given; using {} (--max-depth)",
                                    setup.job.settings.transport.max_depth));
    if (options.ends_by_default)
        lines.push_back(setup.job.stop.target_error
                            ? "no limit given; ending at an error of 2% or after 10 minutes "
                              "(--target-error, --time)"
                            : "no limit given; ending after 10 minutes (--time)");
    if (options.outputs.empty())
        lines.push_back(
            fmt::format("no output given; writing {} (-o)", fmt::join(setup.outputs, " ")));
    return lines;
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
        fault.attempt([&] { write_snapshot(setup.options.snapshots, so_far.film, facts); });
    });
}

RenderStep step_of(const Progress& progress) {
    if (progress.passes > 0) return RenderStep::later_pass;
    return progress.is_learning ? RenderStep::learning : RenderStep::first_pass;
}

/// What rank 0 does while it renders: a progress line, snapshots and checkpoints if wanted.
RenderHooks hooks_of(const RenderSetup& setup, ProgressLine& line, KeptFiles& kept,
                     RunFacts& facts) {
    const RenderOptions& options = setup.options;
    RenderHooks hooks;
    hooks.report = [&](const Progress& p) {
        InterruptGuard::set_answer(answer_while(step_of(p), options));
        line.show(p);
    };
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

/// What is to be said of a picture that is written.
std::vector<std::string> doubts_of(const RenderSetup& setup, const RenderResult& result) {
    const StopSettings& stop = setup.options.stop;
    std::vector<std::string> doubts =
        extrapolation_warnings(result.film, stop.error_terms.extrapolated);
    const auto add = [&](const std::vector<std::string>& lines) {
        doubts.insert(doubts.end(), lines.begin(), lines.end());
    };
    if (result.is_unlearned)
        add({fmt::format(
            "--time {} is too short to learn where photons are needed and to use it: the picture "
            "is that of --photon-sampler uniform, noisier; give it more time",
            duration_text(*stop.seconds))});
    // A dark scene has a black picture for sure, and that has been said.
    if (setup.scene.is_dark()) return doubts;
    add(darkness_warnings(result.film,
                          [&] { return share_lit_by_photons(setup.scene, setup.job.settings); }));
    add(reliability_warnings(result.film));
    return doubts;
}

/// Pictures, doubts, statistics, and what each picture is.
/// @param line  is ended when all pictures are written: a terminal may hold it up.
void write_all(const RenderSetup& setup, const RenderResult& result, RunFacts& facts,
               std::optional<ProgressLine>& line) {
    const RenderOptions& options = setup.options;
    DeferredError faults(LogLevel::quiet);  // thrown when all is tried
    InterruptGuard::set_answer(answer_while(RenderStep::writing, options));
    std::vector<std::string> written;
    InterruptGuard::finish_first([&] {
        written = write_outputs(setup.outputs, result.film,
                                {options.exposure, facts.error_terms.extrapolated}, faults);
    });
    line.reset();
    const std::vector<std::string> doubts = doubts_of(setup, result);
    print_lines(doubts, options.log);
    facts.warnings.insert(facts.warnings.end(), doubts.begin(), doubts.end());
    set_times(facts, result);
    if (!options.stats.empty()) {
        const std::string json = stats_json(result.film, facts);
        InterruptGuard::finish_first(
            [&] { faults.attempt([&] { write_file(options.stats, json); }); });
    }
    const std::string state = state_text(result.film.pass_count(), result.total_seconds,
                                         target_error(result.film, options.stop.error_terms));
    for (std::string& file : written) file += ": " + state;
    if (options.log == LogLevel::info) print_lines(written, options.log);
    faults.finish();
}

/// A rank that writes nothing.
int help_render(const RenderSetup& setup, const Ranks& ranks, LogLevel log) {
    if (setup.options.isa == "avx2" && !cpu_has_avx2())
        print_lines({fmt::format("rank {}: {}", ranks.rank, kNoAvx2)}, log);
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
    RunFacts facts{options.scene, options.command, options.isa, thread_count(), 0, 0, 0, {}, 1, {}};
    facts.ranks = ranks.size;
    facts.error_terms = options.stop.error_terms;
    facts.warnings = warnings_of(options, setup->scene);
    print_lines(facts.warnings, options.log);
    if (options.log == LogLevel::info) print_lines(notes_of(*setup), options.log);
    facts.load_seconds = clock.seconds();

    KeptFiles kept(options);
    std::optional<RenderState> earlier;
    if (setup->checkpoint) earlier = std::move(setup->checkpoint->state);
    const RenderResult result =
        render(setup->job, hooks_of(*setup, *line, kept, facts), std::move(earlier), ranks);
    write_all(*setup, result, facts, line);
    kept.checkpoints.finish();
    kept.snapshots.finish();
    return result.interrupted ? 130 : 0;
}

}  // namespace sunfleck::engine
