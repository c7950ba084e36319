// RenderScheduler: decides for rank 0, between intervals, when the render ends, how long the next
// interval is, and when snapshots and checkpoints are due. With one rank an interval is a pass.
#pragma once

#include "core/stopwatch.h"
#include "film/pass_set.h"
#include "render/render_hooks.h"
#include "render/render_job.h"
#include "render/render_state.h"

namespace sunfleck::engine {

class RenderScheduler {
public:
    /// @param state   of the render, which outlives this; with earlier passes.
    /// @param ranks   their number.
    RenderScheduler(const RenderJob& job, const RenderHooks& hooks, RenderResult& state, int ranks);

    /// Returns the next passes; empty if the render is over.
    PassRange next_interval();

    /// Reports that learning begins or ends.
    void report_learning(bool begins);
    /// Reports how long the camera paths of a trial took during learning.
    void trial_traced(double seconds) { trial_seconds_ = seconds; }
    /// Returns whether learning must be cancelled, or a pass, so that the render ends in time.
    /// Called on any thread during an interval.
    bool cuts_learning() const;
    bool cuts_pass() const;

    /// Passes up to `end` are in the film. @return whether its error, checked at the end of each
    /// batch, reaches the target.
    bool reached_target(std::uint64_t end);

    /// All passes of the interval that count are in the film.
    /// @param of_others  processor time of all other ranks since the render began.
    void interval_ended(double of_others, bool interrupted);

    /// Returns whether the caller wants more passes. The caller may take time over it.
    bool goes_on();

    /// Writes the last snapshot and checkpoint, unless the last interval did.
    void finish();

private:
    /// Updates the error only at the end of a batch, so that resumed and merged renders agree with
    /// a single run.
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
    double learned_before_ = 0;  // seconds of learning up to the interval
    double pass_seconds_ = 0;    // per rank, in the last interval
    double trial_seconds_ = 0;   // of a trial's camera paths during learning
    std::uint64_t interval_passes_ = 0;
    double saved_at_;
    bool interrupted_ = false;
    bool saved_ = false;
    bool shown_ = false;
};

}  // namespace sunfleck::engine
