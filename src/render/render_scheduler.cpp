// Limits, progress, snapshots and checkpoints between intervals.
#include "render/render_scheduler.h"

#include "film/error_bars.h"
#include "math/wavelengths.h"
#include "ranks/reduction_interval.h"

#include <algorithm>
#include <bit>

namespace sunfleck::engine {
namespace {

/// Limit of an interval that has more than one pass per rank, because Ctrl-C waits for its end.
constexpr double kIntervalSeconds = 10;

/// Returns the end with grace: work in progress may exceed the limit by a second, or by 5%.
double end_of_grace(double seconds) {
    constexpr double kGrace = 0.8;
    return seconds + kGrace * std::max(1.0, 0.05 * seconds);
}

/// Ratio of a pass of the sampler `uniform` to its camera paths; 1.2 to 2.8 were measured (cornell,
/// cognac-1, window-room, iced-tea, watch, statue-near; 256 and 1024 pixels a side).
constexpr double kPassOfTrial = 2;

/// Returns the fraction of photon paths that contributed light.
double share_bringing(const Film& film) {
    const double traced = film.statistic("uniform_paths") + film.statistic("guided_paths") +
                          film.statistic("mutated_paths");
    return traced > 0 ? film.statistic("distinct_visible") / traced : 0;
}

std::optional<double> seconds_left(const Progress& p, const RenderJob& job, const Film& film) {
    const StopSettings& stop = job.stop;
    std::optional<double> left;
    const auto at_most = [&](double seconds) {
        left = std::max(0.0, std::min(left.value_or(seconds), seconds));
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

}  // namespace

RenderScheduler::RenderScheduler(const RenderJob& job, const RenderHooks& hooks,
                                 RenderResult& state, int ranks)
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

bool RenderScheduler::is_over() const {
    const StopSettings& stop = job_.stop;
    return interrupted_ || hooks_.is_interrupted() ||
           (stop.seconds && progress_.seconds >= *stop.seconds) ||
           (stop.cpu_seconds && progress_.cpu_seconds >= *stop.cpu_seconds) || is_at(progress_) ||
           !has_room_for_pass() || (!stop.end_pass && is_black());
}

/// Returns whether further passes will be black. If there can be no light, one pass is enough to
/// tell; if nothing is visible, a batch; the same for AOVs of surfaces that are not lit.
bool RenderScheduler::is_black() const {
    const bool is_dark = job_.scene.is_dark();
    if (is_dark && job_.settings.aovs == AovSet{}) return true;
    if (progress_.passes % kBatchPasses != 0) return false;
    return is_dark ||
           (job_.settings.integrator == Integrator::sppm &&
            state_.film.statistic("visible_points") == 0 && image_mean(state_.film) == 0);
}

/// Returns whether another pass can end in time, if it takes as long as the last.
bool RenderScheduler::has_room_for_pass() const {
    constexpr double kFaster = 0.8;
    const auto& seconds = job_.stop.seconds;
    return !seconds || progress_.seconds + kFaster * pass_seconds_ <= end_of_grace(*seconds);
}

bool RenderScheduler::is_late() const {
    const auto& seconds = job_.stop.seconds;
    return seconds && seconds_now() > end_of_grace(*seconds);
}

/// Returns whether learning and the first pass must be cancelled to leave time for a pass without
/// learning: for pictures, but not for checkpoints, which continue later.
bool RenderScheduler::leaves_no_pass() const {
    const auto& seconds = job_.stop.seconds;
    return seconds && !hooks_.save && seconds_now() + kPassOfTrial * trial_seconds_ > *seconds;
}

bool RenderScheduler::cuts_learning() const {
    if (hooks_.is_cancelled()) return true;
    if (progress_.passes == 0) return leaves_no_pass();
    return is_late() || hooks_.is_interrupted();
}

bool RenderScheduler::cuts_pass() const {
    if (hooks_.is_cancelled()) return true;
    if (progress_.passes > 0) return is_late();
    const bool is_learned = trial_seconds_ > 0 && !state_.is_unlearned;
    return is_learned && leaves_no_pass();
}

void RenderScheduler::report_learning(bool begins) {
    if (!hooks_.report) return;
    count_time();
    progress_.seconds = state_.total_seconds;
    progress_.is_learning = begins;
    hooks_.report(progress_);
}

/// Returns the time until something is due, or ranks should synchronise.
double RenderScheduler::seconds_of_interval() const {
    const StopSettings& stop = job_.stop;
    double seconds = kIntervalSeconds;
    if (hooks_.save) seconds = std::min(seconds, hooks_.save_every);
    if (stop.seconds) seconds = std::min(seconds, *stop.seconds - progress_.seconds);
    if (stop.cpu_seconds && progress_.cpu_seconds > 0)
        seconds =
            std::min(seconds, progress_.seconds * (*stop.cpu_seconds / progress_.cpu_seconds - 1));
    return seconds;
}

PassRange RenderScheduler::next_interval() {
    const std::uint64_t begin = std::uint64_t{job_.stop.first_pass} + progress_.passes;
    const auto& end = job_.stop.end_pass;
    const bool is_done = hooks_.is_cancelled() || (progress_.passes > 0 && is_over());
    if (is_done || (end && begin >= *end)) return {begin, begin};
    IntervalLimits limits{
        ranks_, pass_seconds_, seconds_of_interval(), job_.stop.target_error.has_value(), {}};
    const auto at_most = [&](std::uint64_t passes) {
        limits.at_most = std::min(limits.at_most.value_or(passes), passes);
    };
    if (end) at_most(*end - begin);
    if (hooks_.snapshot)
        at_most(std::bit_ceil(std::uint64_t{progress_.passes} + 1) - progress_.passes);
    interval_passes_ = passes_of_interval(limits);
    count_time();
    interval_began_ = state_.total_seconds;
    learned_before_ = state_.seconds.learn;
    return {begin, begin + interval_passes_};
}

void RenderScheduler::ask_error(std::uint64_t end) {
    if (end > 0 && next_batch_end(end - 1) == end)
        progress_.error = target_error(state_.film, job_.stop.error_terms);
}

bool RenderScheduler::reached_target(std::uint64_t end) {
    ask_error(end);
    return is_at(progress_);
}

void RenderScheduler::interval_ended(double of_others, bool interrupted) {
    cpu_seconds_of_others_ = of_others;
    interrupted_ = interrupted_ || interrupted;
    count_time();
    const auto ranks = static_cast<std::uint64_t>(ranks_);
    const std::uint64_t of_a_rank = (interval_passes_ + ranks - 1) / ranks;
    const double learning = state_.seconds.learn - learned_before_;
    pass_seconds_ =
        (state_.total_seconds - interval_began_ - learning) / static_cast<double>(of_a_rank);
    follow();
    if (hooks_.report) hooks_.report(progress_);
    if (hooks_.watch) hooks_.watch(state_.film);
    shown_ = hooks_.snapshot && std::has_single_bit(progress_.passes);
    if (shown_) clock_.aside([&] { hooks_.snapshot(state_); });
    saved_ = hooks_.save && progress_.seconds - saved_at_ >= hooks_.save_every;
    if (!saved_) return;
    saved_at_ = progress_.seconds;
    hooks_.save(state_);
}

bool RenderScheduler::goes_on() {
    bool more = true;
    if (hooks_.goes_on) clock_.aside([&] { more = hooks_.goes_on(); });
    return more;
}

void RenderScheduler::finish() {
    state_.interrupted = interrupted_ || hooks_.is_interrupted();
    if (hooks_.snapshot && !shown_) clock_.aside([&] { hooks_.snapshot(state_); });
    if (hooks_.save && !saved_) hooks_.save(state_);
    count_time();
}

void RenderScheduler::count_time() {
    state_.total_seconds = seconds_before_ + clock_.seconds();
    state_.cpu_seconds = cpu_seconds_before_ + clock_.cpu_seconds() + cpu_seconds_of_others_;
}

/// Updates the progress from the film.
void RenderScheduler::follow() {
    const Film& film = state_.film;
    progress_.passes = static_cast<std::uint32_t>(film.pass_count());
    progress_.seconds = state_.total_seconds;
    progress_.cpu_seconds = state_.cpu_seconds;
    progress_.bringing = share_bringing(film);
    progress_.starved = static_cast<std::uint32_t>(film.statistic("starved_passes"));
    progress_.seconds_left = seconds_left(progress_, job_, film);
}

}  // namespace sunfleck::engine
