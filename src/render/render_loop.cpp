// The loop, and what it does where time is too short to learn.
#include "render/render_loop.h"

#include "render/render_scheduler.h"
#include "render/trial_picture.h"

namespace sunfleck::engine {

RenderResult first_result(const RenderJob& job, std::optional<RenderState> earlier) {
    RenderState state =
        earlier ? std::move(*earlier) : RenderState{.film = Film(key_of(job)), .seconds = {}};
    return {std::move(state), false, false};
}

RenderLoop::RenderLoop(const RenderJob& job, std::optional<RenderState> earlier)
    : job_(job),
      result_(first_result(job, std::move(earlier))),
      passes_(std::in_place, job_, result_) {}

void RenderLoop::run(const StopSettings& stop, const RenderHooks& hooks) {
    job_.stop = stop;
    result_.interrupted = false;
    RenderScheduler scheduler(job_, hooks, result_, 1);
    const PassHooks asked{[&](bool begins) { scheduler.report_learning(begins); },
                          [&](double seconds, const CameraTrial& seen) {
                              scheduler.trial_traced(seconds);
                              if (hooks.preview && result_.film.pass_count() == 0)
                                  hooks.preview(trial_picture(seen, window_of(job_.scene.film())));
                          },
                          [&] { return scheduler.cuts_learning(); },
                          [&] { return scheduler.cuts_pass(); }, hooks.change};
    for (PassRange interval = scheduler.next_interval(); interval.size() > 0;
         interval = scheduler.next_interval()) {
        const auto number = static_cast<std::uint32_t>(interval.begin);
        auto radius_factor = passes_->make(number, result_.film, asked);
        if (!radius_factor && result_.film.pass_count() == 0 && !hooks.is_cancelled()) {
            leave_learning_out(hooks);
            radius_factor = passes_->make(number, result_.film, asked);
        }
        if (!radius_factor) break;
        result_.radius_factor = *radius_factor;
        scheduler.reached_target(interval.end);
        scheduler.interval_ended(0, false);
        if (!scheduler.goes_on()) break;
    }
    scheduler.finish();
}

/// Goes on with the sampler that needs no learning.
void RenderLoop::leave_learning_out(const RenderHooks& hooks) {
    job_.settings.photon.sampler = PhotonSampler::uniform;
    change_film(hooks.change, [&] {
        result_.film = Film(key_of(job_));
        result_.is_unlearned = true;
        passes_.emplace(job_, result_);
    });
}

}  // namespace sunfleck::engine
