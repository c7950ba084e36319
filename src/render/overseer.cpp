// Limits, progress, snapshots and checkpoints of a render, between its turns.
#include "render/overseer.h"

#include "render/turns.h"

#include <algorithm>
#include <bit>

namespace sunfleck {
namespace {

/// A turn should not take longer where it takes more than a pass a rank: Ctrl-C waits for its end.
constexpr double kTurnSeconds = 10;

/// Photon paths; camera paths where there are none.
double paths_of(const Film& film, Integrator integrator) {
    if (integrator == Integrator::path || integrator == Integrator::bdpt)
        return static_cast<double>(film.key().pixels() * film.pass_count());
    return film.statistic("uniform_paths") + film.statistic("mapped_paths") +
           film.statistic("mutated_paths");
}

std::optional<double> seconds_left(const Progress& p, const RenderJob& job, const Film& film) {
    const StopSettings& stop = job.stop;
    std::optional<double> left;
    const auto at_most = [&](double seconds) {
        left = std::min(left.value_or(seconds), std::max(0.0, seconds));
    };
    if (p.of) at_most(p.seconds / p.passes * (*p.of - p.passes));
    if (stop.seconds) at_most(*stop.seconds - p.seconds);
    if (stop.cpu_seconds) at_most(p.seconds * (*stop.cpu_seconds / p.cpu_seconds - 1));
    if (p.error && p.target)
        at_most(p.seconds / p.passes * passes_left(film, *p.error, *p.target, job.settings.alpha));
    return left;
}

bool is_at(const Progress& progress) {
    return progress.error && progress.target && progress.error->value() <= *progress.target;
}

void follow_groups(const std::vector<GroupCounts>& groups, Progress& progress) {
    progress.levels.clear();
    Acceptance mutations;
    for (const GroupCounts& group : groups) {
        const std::size_t sets = group.ladder.levels.size();
        progress.levels.push_back(sets == 0 ? 0 : sets - 1);
        mutations += group.ladder.mutations();
    }
    progress.acceptance = mutations.share();
}

}  // namespace

Overseer::Overseer(const RenderJob& job, const RenderHooks& hooks, RenderResult& state, int ranks)
    : job_(job),
      hooks_(hooks),
      state_(state),
      ranks_(ranks),
      seconds_before_(state.total_seconds),
      cpu_seconds_before_(state.cpu_seconds),
      saved_at_(state.total_seconds) {
    progress_.target = job.stop.target_error;
    if (job.stop.end_pass) progress_.of = *job.stop.end_pass - job.stop.first_pass;
    progress_.passes = static_cast<std::uint32_t>(state.film.pass_count());
    progress_.seconds = state.total_seconds;
    progress_.cpu_seconds = state.cpu_seconds;
    ask_error(std::uint64_t{job.stop.first_pass} + progress_.passes);
}

bool Overseer::is_over() const {
    const StopSettings& stop = job_.stop;
    return interrupted_ || (hooks_.interrupted != nullptr && *hooks_.interrupted) ||
           (stop.seconds && progress_.seconds >= *stop.seconds) ||
           (stop.cpu_seconds && progress_.cpu_seconds >= *stop.cpu_seconds) || is_at(progress_);
}

/// Until something is due, or all should meet.
double Overseer::seconds_of_turn() const {
    const StopSettings& stop = job_.stop;
    double seconds = kTurnSeconds;
    if (hooks_.save) seconds = std::min(seconds, hooks_.save_every);
    if (stop.seconds) seconds = std::min(seconds, *stop.seconds - progress_.seconds);
    if (stop.cpu_seconds && progress_.cpu_seconds > 0)
        seconds =
            std::min(seconds, progress_.seconds * (*stop.cpu_seconds / progress_.cpu_seconds - 1));
    return seconds;
}

PassRange Overseer::next_turn() {
    const std::uint64_t begin = std::uint64_t{job_.stop.first_pass} + progress_.passes;
    const auto& end = job_.stop.end_pass;
    if ((end && begin >= *end) || (progress_.passes > 0 && is_over())) return {begin, begin};
    TurnLimits limits{
        ranks_, pass_seconds_, seconds_of_turn(), job_.stop.target_error.has_value(), {}};
    const auto at_most = [&](std::uint64_t passes) {
        limits.at_most = std::min(limits.at_most.value_or(passes), passes);
    };
    if (end) at_most(*end - begin);
    if (hooks_.snapshot)
        at_most(std::bit_ceil(std::uint64_t{progress_.passes} + 1) - progress_.passes);
    turn_passes_ = passes_of_turn(limits);
    count_time();
    turn_began_ = state_.total_seconds;
    return {begin, begin + turn_passes_};
}

void Overseer::ask_error(std::uint64_t end) {
    if (end % kRoundPasses == 0) progress_.error = target_error(state_.film, job_.stop.error_terms);
}

bool Overseer::reached_target(std::uint64_t end) {
    ask_error(end);
    return is_at(progress_);
}

void Overseer::turn_ended(const std::vector<GroupCounts>& last, double of_others,
                          bool interrupted) {
    cpu_seconds_of_others_ = of_others;
    interrupted_ = interrupted_ || interrupted;
    follow_groups(last, progress_);
    count_time();
    const auto ranks = static_cast<std::uint64_t>(ranks_);
    const std::uint64_t of_a_rank = (turn_passes_ + ranks - 1) / ranks;
    pass_seconds_ = (state_.total_seconds - turn_began_) / static_cast<double>(of_a_rank);
    follow();
    if (hooks_.report) hooks_.report(progress_);
    shown_ = hooks_.snapshot && std::has_single_bit(progress_.passes);
    if (shown_) clock_.aside([&] { hooks_.snapshot(state_); });
    saved_ = hooks_.save && progress_.seconds - saved_at_ >= hooks_.save_every;
    if (!saved_) return;
    saved_at_ = progress_.seconds;
    hooks_.save(state_);
}

void Overseer::finish() {
    state_.interrupted = interrupted_ || (hooks_.interrupted != nullptr && *hooks_.interrupted);
    if (hooks_.snapshot && !shown_) clock_.aside([&] { hooks_.snapshot(state_); });
    if (hooks_.save && !saved_) hooks_.save(state_);
    count_time();
}

void Overseer::count_time() {
    state_.total_seconds = seconds_before_ + clock_.seconds();
    state_.cpu_seconds = cpu_seconds_before_ + clock_.cpu_seconds() + cpu_seconds_of_others_;
}

/// What the film tells.
void Overseer::follow() {
    const Film& film = state_.film;
    progress_.passes = static_cast<std::uint32_t>(film.pass_count());
    progress_.seconds = state_.total_seconds;
    progress_.cpu_seconds = state_.cpu_seconds;
    progress_.visible_fraction = film.statistic("visible_fraction") / progress_.passes;
    progress_.starved = static_cast<std::uint32_t>(film.statistic("starved_passes"));
    progress_.paths_per_second = paths_of(film, job_.settings.integrator) / progress_.seconds;
    progress_.seconds_left = seconds_left(progress_, job_, film);
}

}  // namespace sunfleck
