// What rank 0 asks between intervals: is the render over, how long is the next interval, is a
// snapshot or a checkpoint due? With one rank an interval is a pass.
#pragma once

#include "core/stopwatch.h"
#include "film/pass_set.h"
#include "render/render_hooks.h"
#include "render/render_job.h"
#include "render/render_state.h"

namespace sunfleck::engine {

class RenderScheduler {
public:
    /// @param state   the render's, which outlives this; its passes so far are those before.
    /// @param ranks   how many there are.
    RenderScheduler(const RenderJob& job, const RenderHooks& hooks, RenderResult& state, int ranks);

    /// Passes that are next; empty if the render is over.
    PassRange next_interval();

    /// Learning begins, or is over.
    void report_learning(bool begins);
    /// Learning has traced camera paths like those of a pass, in so many seconds.
    void view_traced(double seconds) { view_seconds_ = seconds; }
    /// Is learning under way, or a pass, to be cut short, so that the render ends in time? Asked on
    /// any thread during an interval.
    bool cuts_learning() const;
    bool cuts_pass() const;

    /// Passes up to `end` are in the film. @return is its error, asked at the end of each batch,
    /// at the target?
    bool reached_target(std::uint64_t end);

    /// All passes of the interval that count are in the film.
    /// @param of_others  processor time of all other ranks since the render began.
    void interval_ended(double of_others, bool interrupted);

    /// The last snapshot and the last checkpoint, if those of the last interval were not.
    void finish();

private:
    /// Where a batch ends: of other passes a render in one go knows no error, either.
    void ask_error(std::uint64_t end);
    bool is_over() const;
    bool is_black() const;
    double seconds_now() const { return seconds_before_ + clock_.seconds(); }
    bool is_late() const;
    bool leaves_no_pass() const;
    bool has_room_for_pass() const;
    double seconds_of_interval() const;
    void count_time();
    void follow();

    const RenderJob& job_;
    const RenderHooks& hooks_;
    RenderResult& state_;
    int ranks_;
    WorkClock clock_;
    double seconds_before_;
    double cpu_seconds_before_;
    double cpu_seconds_of_others_ = 0;
    Progress progress_;
    double interval_began_ = 0;
    double learned_before_ = 0;  // seconds of learning, up to the interval
    double pass_seconds_ = 0;    // a rank's, in the last interval
    double view_seconds_ = 0;    // of camera paths while learning
    std::uint64_t interval_passes_ = 0;
    double saved_at_;
    bool interrupted_ = false;
    bool saved_ = false;
    bool shown_ = false;
};

}  // namespace sunfleck::engine
