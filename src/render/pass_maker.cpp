// Passes one after the other.
#include "render/pass_maker.h"

#include "render/count_pass.h"

#include <utility>

namespace sunfleck {
bool is_sequential(const RenderSettings& settings) {
    return settings.integrator == Integrator::sppm &&
           settings.photon.sampler == PhotonSampler::paper;
}

PassMaker::PassMaker(const RenderJob& job, RenderState& state) : job_(job), state_(state) {
    if (!is_sequential(job.settings)) return;
    if (!state.paper) state.paper.emplace(job.settings, state.film.key().pixels());
    paper_.emplace(job.scene, job.settings, *state.paper);
}

PassNote PassMaker::make(std::uint32_t number, Film& film) {
    if (!paper_ && (!epoch_ || epoch_->number != epoch_of(number))) {
        epoch_ = learn_epoch(job_.scene, job_.settings, number);
        state_.seconds.learn += epoch_->seconds;
    }
    PassResult pass =
        paper_ ? paper_->next_pass() : render_pass(job_.scene, job_.settings, number, *epoch_);
    add_pass(film, number, pass);
    if (paper_) paper_->count(film);
    state_.seconds += pass.seconds;
    return {std::move(pass.groups), pass.radius_factor};
}

}  // namespace sunfleck
