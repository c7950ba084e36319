// One machine by itself, or the loop over intervals of several ranks.
#include "render/progressive.h"

#include "photon_samplers/samplers.h"
#include "ranks/shared_interval.h"
#include "render/pass_maker.h"
#include "render/render_loop.h"
#include "render/render_scheduler.h"
#include "sunfleck/error.h"

#include <array>
#include <utility>

namespace sunfleck::engine {
namespace {

/// Rank 0 chooses each interval and keeps the film.
RenderResult render_among(const Ranks& ranks, const RenderJob& job, const RenderHooks& hooks,
                          RenderResult result) {
    const WorkClock clock;
    RenderScheduler scheduler(job, hooks, result, ranks.size);
    PassMaker passes(job, result);
    SharedInterval shared(
        ranks, result.film.key(), job.stop.target_error.has_value(),
        [&](std::uint32_t number, Film& film) { return *passes.make(number, film); });
    const auto note = [&] {
        return RankNote{ranks.is_first() ? 0 : clock.cpu_seconds(),
                        hooks.interrupted != nullptr && *hooks.interrupted};
    };
    while (true) {
        std::array<PassRange, 1> interval{};
        if (ranks.is_first()) interval[0] = scheduler.next_interval();
        broadcast(ranks, std::as_writable_bytes(std::span(interval)));
        if (interval[0].size() == 0) break;
        bool over = false;
        const auto take = [&](const PassRange& part, const Film& film, double radius_factor) {
            if (over) return;  // a single machine would not have rendered it
            merge(result.film, film);
            result.radius_factor = radius_factor;
            over = scheduler.reached_target(part.end);
        };
        const RankNote all = shared.render(interval[0], note, take);
        if (ranks.is_first()) scheduler.interval_ended(all.cpu_seconds, all.interrupted);
    }
    if (ranks.is_first()) scheduler.finish();
    return result;
}

}  // namespace

void check_shareable(const RenderSettings& settings, const Ranks& ranks) {
    if (ranks.is_alone() || !is_sequential(settings)) return;
    throw Error({"--photon-sampler"},
                std::string(name_of(settings.photon.sampler)) +
                    " builds each pass on those before, and " + std::to_string(ranks.size) +
                    " ranks cannot share them",
                "use one rank, or another sampler");
}

RenderResult render(const RenderJob& job, const RenderHooks& hooks,
                    std::optional<RenderState> earlier, const Ranks& ranks) {
    if (ranks.is_alone()) {
        RenderLoop loop(job, std::move(earlier));
        loop.run(job.stop, hooks);
        return loop.take();
    }
    check_shareable(job.settings, ranks);
    return render_among(ranks, job, hooks, first_result(job, std::move(earlier)));
}

}  // namespace sunfleck::engine
