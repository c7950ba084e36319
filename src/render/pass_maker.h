// Passes one after the other, each added to a film.
#pragma once

#include "planning/learn_epoch.h"
#include "render/render_hooks.h"
#include "render/render_job.h"
#include "render/render_state.h"

#include <functional>
#include <optional>

namespace sunfleck::engine {

/// What is asked and told while a pass is made. Each may be absent.
struct PassHooks {
    std::function<void(bool begins)> learning;  // begins, or is over
    TrialTraced trial_traced;                   // while learning
    std::function<bool()> cuts_learning;        // asked on any thread: is it to be cut short?
    std::function<bool()> cuts_pass;            // the same of the pass itself
    FilmChange change;                          // as in RenderHooks
};

class PassMaker {
public:
    /// @param state  its seconds grow with each pass, and the sampler's state goes on.
    PassMaker(const RenderJob& job, RenderState& state);

    /// Renders a pass and adds it, with all that it counted, to a film of this job.
    /// @return its radius factor, or nothing if it was cut short: then the film has not changed.
    ///         Passes of a sampler with a state never are: they change it while they run.
    std::optional<double> make(std::uint32_t number, Film& film, PassHooks hooks = {});

private:
    bool learn(std::uint32_t number, const PassHooks& hooks);

    const RenderJob& job_;
    RenderState& state_;
    std::optional<Epoch> epoch_;
};

}  // namespace sunfleck::engine
