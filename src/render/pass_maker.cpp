// Passes one after the other.
#include "render/pass_maker.h"

#include "core/parallel.h"
#include "render/count_pass.h"
#include "render/pass.h"

#include <utility>

namespace sunfleck::engine {

PassMaker::PassMaker(const RenderJob& job, RenderState& state, PassHooks hooks)
    : job_(job), state_(state), hooks_(std::move(hooks)) {
    if (!is_sequential(job.settings)) return;
    hooks_.cuts_learning = {};
    hooks_.cuts_pass = {};
    if (std::holds_alternative<NoState>(state.sampler))
        state.sampler =
            first_state(job.settings.photon, job.settings.alpha, state.film.key().pixels());
}

/// @return false if it was cut short.
bool PassMaker::learn(std::uint32_t number) {
    if (epoch_ && epoch_->number == epoch_of(number)) return true;
    const bool is_told = hooks_.learning && needs_learning(job_.scene, job_.settings);
    if (is_told) hooks_.learning(true);
    const bool is_learned = run_unless(hooks_.cuts_learning, [&] {
        epoch_ = learn_epoch(job_.scene, job_.settings, number, hooks_.view_traced);
    });
    if (is_told) hooks_.learning(false);
    if (is_learned) state_.seconds.learn += epoch_->seconds;
    return is_learned;
}

std::optional<double> PassMaker::make(std::uint32_t number, Film& film) {
    std::optional<PassResult> pass;
    if (!learn(number)) return {};
    const bool is_whole = run_unless(hooks_.cuts_pass, [&] {
        pass.emplace(render_pass(job_.scene, job_.settings, number, *epoch_, state_.sampler));
    });
    if (!is_whole) return {};
    add_pass(film, number, *pass);
    state_.seconds += pass->seconds;
    return pass->radius_factor;
}

}  // namespace sunfleck::engine
