// Passes in order.
#include "render/pass_maker.h"

#include "core/parallel.h"
#include "photon_samplers/samplers.h"
#include "render/count_pass.h"
#include "render/pass.h"

#include <utility>

namespace sunfleck::engine {

PassMaker::PassMaker(const RenderJob& job, RenderState& state) : job_(job), state_(state) {
    if (is_sequential(job.settings) && std::holds_alternative<NoState>(state.sampler))
        state.sampler =
            first_state(job.settings.photon, job.settings.alpha, state.film.key().pixels());
}

/// @return false if it was cancelled.
bool PassMaker::learn(std::uint32_t number, const PassHooks& hooks) {
    const RenderSettings& settings = job_.settings;
    if (epoch_ && serves(*epoch_, job_.scene, settings, number)) return true;
    // Others look for edges alone, as long as a pass takes, and are what is left if time is over.
    const bool learns = needs_learning(job_.scene, settings);
    const bool is_told = hooks.learning && learns;
    if (is_told) hooks.learning(true);
    const bool is_learned = run_unless(learns ? hooks.cuts_learning : nullptr, [&] {
        epoch_ = learn_epoch(job_.scene, settings, number, hooks.trial_traced,
                             epoch_ ? &*epoch_ : nullptr);
    });
    if (is_told) hooks.learning(false);
    if (!is_learned) return false;
    state_.seconds.learn += epoch_->seconds;
    return true;
}

std::optional<double> PassMaker::make(std::uint32_t number, Film& film, PassHooks hooks) {
    if (is_sequential(job_.settings)) {
        hooks.cuts_learning = {};
        hooks.cuts_pass = {};
    }
    std::optional<PassResult> pass;
    if (!learn(number, hooks)) return {};
    const bool is_whole = run_unless(hooks.cuts_pass, [&] {
        pass.emplace(render_pass(job_.scene, job_.settings, number, *epoch_, state_.sampler));
    });
    if (!is_whole) return {};
    change_film(hooks.change, [&] {
        add_pass(film, number, *pass);
        state_.seconds += pass->seconds;
    });
    return pass->radius_factor;
}

}  // namespace sunfleck::engine
