// `sunfleck render`: scene in, pictures out.
#include "apps/cli/commands.h"
#include "apps/cli/image_stats.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/outputs.h"
#include "apps/cli/progress.h"
#include "apps/cli/render_setup.h"
#include "apps/cli/snapshots.h"
#include "apps/cli/stats.h"
#include "apps/cli/together.h"
#include "core/parallel.h"
#include "core/stopwatch.h"
#include "core/thread_trial.h"
#include "image/atomic_file.h"
#include "render/shared_turn.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>

namespace sunfleck {
namespace {

void print_lines(const std::vector<std::string>& lines, LogLevel log) {
    if (log == LogLevel::quiet) return;
    for (const std::string& line : lines) fmt::print(stderr, "{}\n", line);
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
        lines.push_back(fmt::format("no greatest depth is given: --max-depth {}",
                                    setup.job.settings.transport.max_depth));
    if (options.ends_by_default)
        lines.push_back(setup.job.stop.target_error
                            ? "no end is given: --target-error 2% --time 10m, what comes first"
                            : "no end is given: --time 10m");
    if (options.outputs.empty())
        lines.push_back(fmt::format("no output is given: -o {}", fmt::join(setup.outputs, " ")));
    return lines;
}

void set_times(RunFacts& facts, const RenderState& state) {
    facts.seconds = state.seconds;
    facts.radius_factor = state.radius_factor;
    facts.total_seconds = facts.load_seconds + state.total_seconds;
    facts.cpu_seconds = state.cpu_seconds;
}

/// What goes on beside a render: the files that it keeps, and their faults.
struct Beside {
    CheckpointKeeper checkpoints;
    LateFault snapshots;  // one that is missing is missed, whatever follows

    explicit Beside(const RenderOptions& options) : checkpoints(options), snapshots(options.log) {}
};

void keep_snapshot(const RenderSetup& setup, const RenderState& so_far, LateFault& fault,
                   RunFacts& facts) {
    set_times(facts, so_far);
    InterruptGuard::finish_first([&] {
        fault.attempt([&] { write_snapshot(setup.options.snapshots, so_far.film, facts); });
    });
}

/// What rank 0 does while it renders: a progress line, snapshots and checkpoints if wanted.
RenderHooks hooks_of(const RenderSetup& setup, ProgressLine& line, Beside& beside,
                     RunFacts& facts) {
    const RenderOptions& options = setup.options;
    RenderHooks hooks;
    hooks.report = [&](const Progress& p) { line.show(p); };
    hooks.interrupted = &InterruptGuard::interrupted();
    if (!options.snapshots.empty())
        hooks.snapshot = [&](const RenderResult& so_far) {
            keep_snapshot(setup, so_far, beside.snapshots, facts);
        };
    if (!options.checkpoint.empty())
        hooks.save = [&](const RenderState& state) {
            beside.checkpoints.save(setup.origin, state);
        };
    hooks.save_every = options.checkpoint_seconds;
    return hooks;
}

/// Pictures, doubts, statistics.
void write_all(const RenderSetup& setup, const RenderResult& result, RunFacts& facts) {
    const RenderOptions& options = setup.options;
    LateFault faults(LogLevel::quiet);  // thrown when all is tried
    InterruptGuard::finish_first([&] {
        write_outputs(setup.outputs, result.film,
                      {options.exposure, facts.error_terms.extrapolated}, faults);
    });
    auto doubts = extrapolation_warnings(result.film, facts.error_terms.extrapolated);
    // Without a light the picture is black for sure, and that has been said.
    if (!setup.scene.lights().empty())
        for (const std::string& line : reliability_warnings(result.film)) doubts.push_back(line);
    print_lines(doubts, options.log);
    facts.warnings.insert(facts.warnings.end(), doubts.begin(), doubts.end());
    set_times(facts, result);
    if (!options.stats.empty()) {
        const std::string json = stats_json(result.film, facts);
        InterruptGuard::finish_first(
            [&] { faults.attempt([&] { write_file(options.stats, json); }); });
    }
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
    const ThreadLimit limit(asked.threads);
    together(ranks, [&] {
        try_threads();
        return true;
    });
    const auto setup = together(ranks, [&] { return prepare(options_of(asked, ranks), ranks); });
    together(ranks, [&] {
        check_same_render(ranks, key_of(setup->job));
        return true;
    });
    const RenderOptions& options = setup->options;
    const InterruptGuard guard;
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

    Beside beside(options);
    std::optional<RenderState> earlier;
    if (setup->checkpoint) earlier = std::move(setup->checkpoint->state);
    const RenderResult result = [&] {
        ProgressLine line(options.log == LogLevel::info);
        return render(setup->job, hooks_of(*setup, line, beside, facts), std::move(earlier), ranks);
    }();
    write_all(*setup, result, facts);
    beside.checkpoints.finish();
    beside.snapshots.finish();
    return result.interrupted ? 130 : 0;
}

}  // namespace sunfleck
