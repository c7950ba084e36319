// Passes one after the other, and what a film counts of them.
#include "render/pass_maker.h"

#include <utility>

namespace sunfleck {
namespace {

/// Level by level, as sums over passes.
void count_ladder(Film& film, const LadderCounts& ladder) {
    for (std::size_t k = 0; k < ladder.levels.size(); ++k) {
        const std::string level = "ladder." + std::to_string(k) + ".";
        const Acceptance mutations = ladder.levels[k].mutations();
        film.count(level + "states", ladder.levels[k].states);
        film.count(level + "survivors", k < ladder.survivors.size() ? ladder.survivors[k] : 0);
        film.count(level + "proposed", mutations.proposed);
        film.count(level + "accepted", mutations.accepted);
    }
}

bool is_starved(const PassResult& pass) {
    return pass.statistics[Count::visible_states] == 0;
}

void add_pass(Film& film, std::uint32_t number, const PassResult& pass) {
    film.add_pass(number, pass.image);
    for (const CountRow& row : kCountRows)
        if (row.count != Count::dropped_nonfinite && row.count != Count::saturated)
            film.count(row.name, pass.statistics[row.count]);
    if (pass.statistics[Count::uniform_paths] == 0) return;
    film.count("starved_passes", is_starved(pass) ? 1 : 0);
    film.sum("visible_fraction", pass.visible_fraction);
    film.sum("visible_fraction_square", pass.visible_fraction * pass.visible_fraction);
    count_ladder(film, pass.ladder);
}

}  // namespace

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
    return {std::move(pass.ladder), pass.radius_factor};
}

}  // namespace sunfleck
