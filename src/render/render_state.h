// A render so far: its film, and all else that goes from one pass to the next.
#pragma once

#include "film/film.h"
#include "photon_samplers/sampler_state.h"
#include "stages/pass_result.h"

namespace sunfleck::engine {

/// All that goes from one pass to the next. What adaptive sampling has learned is no part of it: an
/// epoch's plan is learned again, to the same bits, from the number of the pass
/// (planning/learn_epoch.h).
struct RenderState {
    Film film;
    PassTimes seconds;
    double total_seconds = 0;  // of rendering, on the wall
    double cpu_seconds = 0;    // the same of all threads together
    double radius_factor = 1;  // of the last pass
    SamplerState sampler{};    // of the photon sampler after the last pass, if it has one
};

struct RenderResult : RenderState {
    bool interrupted = false;
    /// Time was too short to learn where photons are needed: in place of the job's
    /// passes there are those of the sampler `uniform`, under the key of that.
    bool is_unlearned = false;
};

}  // namespace sunfleck::engine
