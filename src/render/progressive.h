// A whole render: passes one after the other until a limit, added up in a film.
//
// In:  scene, settings, limits, and earlier passes to go on from. Out: the film. Only whole passes
// go into it, and never what depends on the clock: a limit of time cuts the last pass short, or the
// learning before it, and leaves it out. Several ranks render it together, to the same bytes
// (ranks.h, turns.h).
#pragma once

#include "film/film.h"
#include "render/paper_memory.h"
#include "render/pass.h"
#include "render/ranks.h"

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

namespace sunfleck {

/// What is known after a pass.
struct Progress {
    std::uint32_t passes = 0;  // rendered so far
    std::optional<std::uint32_t> of;
    double seconds = 0;
    double cpu_seconds = 0;            // of all threads
    std::optional<TargetError> error;  // from complete rounds
    std::optional<double> target;
    std::optional<double> seconds_left;  // an estimate
    double bringing = 0;                 // share of photon paths that brought light
    std::uint32_t starved = 0;           // passes that found no visible photon path
    bool is_learning = false;            // where photons are needed, before the next pass
};

/// All that goes from one pass to the next. What adaptive sampling has learned is no part of it: an
/// epoch's plan is learned again, to the same bits, from the number of the pass (render/epoch.h).
struct RenderState {
    Film film;
    PassTimes seconds;
    double total_seconds = 0;          // of rendering, on the wall
    double cpu_seconds = 0;            // the same of all threads together
    double radius_factor = 1;          // of the last pass
    std::optional<PaperMemory> paper;  // of the sampler `paper` alone
};

struct RenderResult : RenderState {
    bool interrupted = false;
    /// Time was too short to learn where photons are needed: in place of the job's
    /// passes there are those of the sampler `uniform`, under the key of that.
    bool is_unlearned = false;
};

struct RenderHooks {
    /// After each pass, or turn of several ranks, and before and after an epoch is learned.
    std::function<void(const Progress&)> report;
    /// After 1, 2, 4, 8 ... passes and at the end; its time does not count.
    std::function<void(const RenderResult&)> snapshot;
    /// Asked after each pass, and while epochs are learned but the first.
    const std::atomic<bool>* interrupted = nullptr;
    /// After a pass when `save_every` seconds have gone since the last call began, and at the end.
    std::function<void(const RenderState&)> save;
    double save_every = 60;
};

/// What a render is to be compared by: scene_hash is of all that the scene's files hold.
struct RenderJob {
    const Scene& scene;
    RenderSettings settings;
    StopSettings stop;
    std::uint64_t scene_hash = 0;
};

/// What parts of one render have in common.
FilmKey key_of(const RenderJob& job);

/// @throws Error for several ranks and a sampler whose passes build on those before.
void check_shareable(const RenderSettings& settings, const Ranks& ranks);

/// @param earlier  passes of this job to go on from, the job's first pass to some other without a
///                 gap: the result is as if they were rendered now. Their seconds count.
/// @param ranks    all of them call this with one job and the same limits. Rank 0's earlier passes
///                 and hooks count, and it has the result; others need `interrupted` alone.
/// @throws Error as check_shareable() does.
RenderResult render(const RenderJob& job, const RenderHooks& hooks,
                    std::optional<RenderState> earlier = {}, const Ranks& ranks = {});

}  // namespace sunfleck
