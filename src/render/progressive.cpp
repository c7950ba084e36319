// The loop over passes, and when it ends.
#include "render/progressive.h"

#include "core/stopwatch.h"
#include "film/error_bars.h"
#include "render/count_pass.h"
#include "render/paper.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sunfleck {
namespace {

bool is_paper(const RenderSettings& settings) {
    return settings.integrator == Integrator::sppm &&
           settings.photon.sampler == PhotonSampler::paper;
}

/// Photon paths; camera paths where there are none.
double paths_of(const Film& film, Integrator integrator) {
    if (integrator == Integrator::path || integrator == Integrator::bdpt)
        return static_cast<double>(film.key().pixels() * film.pass_count());
    return film.statistic("uniform_paths") + film.statistic("mutated_paths");
}

/// The error falls about with the root of the number of passes; the bias of the radius apart.
std::optional<double> seconds_left(const Progress& p, const StopSettings& stop) {
    std::optional<double> left;
    const auto at_most = [&](double seconds) {
        left = std::min(left.value_or(seconds), std::max(0.0, seconds));
    };
    if (p.of) at_most(p.seconds / p.passes * (*p.of - p.passes));
    if (stop.seconds) at_most(*stop.seconds - p.seconds);
    if (p.error && p.target) at_most(p.seconds * (std::pow(*p.error / *p.target, 2) - 1));
    return left;
}

/// What the film tells; the rest is of the last pass alone.
void follow(const RenderState& state, const RenderJob& job, Progress& progress) {
    const Film& film = state.film;
    progress.passes = static_cast<std::uint32_t>(film.pass_count());
    progress.seconds = state.total_seconds;
    progress.visible_fraction = film.statistic("visible_fraction") / progress.passes;
    progress.starved = static_cast<std::uint32_t>(film.statistic("starved_passes"));
    progress.paths_per_second = paths_of(film, job.settings.integrator) / progress.seconds;
    progress.seconds_left = seconds_left(progress, job.stop);
}

void follow(const std::vector<GroupCounts>& groups, Progress& progress) {
    progress.levels.clear();
    Acceptance mutations;
    for (const GroupCounts& group : groups) {
        const std::size_t sets = group.ladder.levels.size();
        progress.levels.push_back(sets == 0 ? 0 : sets - 1);
        mutations += group.ladder.mutations();
    }
    progress.acceptance = mutations.proposed == 0 ? 0
                                                  : static_cast<double>(mutations.accepted) /
                                                        static_cast<double>(mutations.proposed);
}

/// Renders passes in their order and adds them to a state.
class PassMaker {
public:
    PassMaker(const RenderJob& job, RenderState& state) : job_(job), state_(state) {
        if (!is_paper(job.settings)) return;
        if (!state.paper) state.paper.emplace(job.settings, state.film.key().pixels());
        paper_.emplace(job.scene, job.settings, *state.paper);
    }

    /// @return counts of its groups of lights.
    std::vector<GroupCounts> make(std::uint32_t number) {
        if (!paper_ && (!epoch_ || epoch_->number != epoch_of(number))) {
            epoch_ = learn_epoch(job_.scene, job_.settings, number);
            state_.seconds.learn += epoch_->seconds;
        }
        PassResult pass =
            paper_ ? paper_->next_pass() : render_pass(job_.scene, job_.settings, number, *epoch_);
        add_pass(state_.film, number, pass);
        if (paper_) paper_->count(state_.film);
        state_.seconds += pass.seconds;
        state_.radius_factor = pass.radius_factor;
        return std::move(pass.groups);
    }

private:
    const RenderJob& job_;
    RenderState& state_;
    std::optional<Epoch> epoch_;
    std::optional<PaperRender> paper_;
};

/// After one pass or more.
bool is_over(const Progress& progress, const StopSettings& stop) {
    return (stop.seconds && progress.seconds >= *stop.seconds) ||
           (progress.error && progress.target && *progress.error <= *progress.target);
}

}  // namespace

FilmKey key_of(const RenderJob& job) {
    const PixelWindow window = window_of(job.scene.film());
    const Vec2i whole = job.scene.film().resolution;
    FilmKey key{window.width(),    window.height(), job.settings.layers,
                job.settings.seed, job.scene_hash,  job.settings.text()};
    key.settings += "resolution=" + std::to_string(whole.x) + "x" + std::to_string(whole.y) +
                    "\nwindow=" + std::to_string(window.x0) + "," + std::to_string(window.y0) +
                    "\n";
    key.sequential = is_paper(job.settings);
    return key;
}

RenderResult render(const RenderJob& job, const RenderHooks& hooks,
                    std::optional<RenderState> earlier) {
    WorkClock clock;
    const StopSettings& stop = job.stop;
    RenderState begin =
        earlier ? std::move(*earlier) : RenderState{Film(key_of(job)), {}, 0, 0, 1, {}};
    RenderResult result{std::move(begin), false};
    const auto count_time = [&, wall = result.total_seconds, cpu = result.cpu_seconds] {
        result.total_seconds = wall + clock.seconds();
        result.cpu_seconds = cpu + clock.cpu_seconds();
    };
    PassMaker passes(job, result);
    Progress progress;
    progress.target = stop.target_error;
    if (stop.end_pass) progress.of = *stop.end_pass - stop.first_pass;
    progress.passes = static_cast<std::uint32_t>(result.film.pass_count());
    progress.seconds = result.total_seconds;
    if (progress.passes > 0) progress.error = target_error(result.film);
    const auto interrupted = [&] { return hooks.interrupted != nullptr && *hooks.interrupted; };
    const auto goes_on = [&](std::uint32_t number) {
        if (stop.end_pass && number >= *stop.end_pass) return false;
        return progress.passes == 0 || !(interrupted() || is_over(progress, stop));
    };
    double saved_at = progress.seconds;
    bool saved = false;
    bool shown = false;
    for (std::uint32_t number = stop.first_pass + progress.passes; goes_on(number); ++number) {
        follow(passes.make(number), progress);
        count_time();
        if ((number + 1) % kRoundPasses == 0) progress.error = target_error(result.film);
        follow(result, job, progress);
        if (hooks.report) hooks.report(progress);
        shown = hooks.snapshot && std::has_single_bit(progress.passes);
        if (shown) clock.aside([&] { hooks.snapshot(result); });
        saved = hooks.save && progress.seconds - saved_at >= hooks.save_every;
        if (!saved) continue;
        saved_at = progress.seconds;
        hooks.save(result);
    }
    result.interrupted = interrupted();
    if (hooks.snapshot && !shown) clock.aside([&] { hooks.snapshot(result); });
    if (hooks.save && !saved) hooks.save(result);
    count_time();
    return result;
}

}  // namespace sunfleck
