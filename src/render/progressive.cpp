// The loop over intervals.
#include "render/progressive.h"

#include "ranks/shared_interval.h"
#include "render/pass_maker.h"
#include "render/render_scheduler.h"
#include "sunfleck/error.h"

#include <array>
#include <utility>

namespace sunfleck::engine {
namespace {

RenderResult begin_of(const RenderJob& job, std::optional<RenderState> earlier) {
    RenderState state =
        earlier ? std::move(*earlier) : RenderState{Film(key_of(job)), {}, 0, 0, 1, {}};
    return {std::move(state), false, false};
}

/// The job with the sampler that needs no learning.
RenderJob unlearned(const RenderJob& job) {
    RenderJob plain = job;
    plain.settings.photon.sampler = PhotonSampler::uniform;
    return plain;
}

/// An interval is a pass, and goes into the film at once.
RenderResult render_alone(const RenderJob& job, const RenderHooks& hooks, RenderResult result) {
    RenderScheduler scheduler(job, hooks, result, 1);
    const PassHooks asked{[&](bool begins) { scheduler.report_learning(begins); },
                          [&](double seconds) { scheduler.view_traced(seconds); },
                          [&] { return scheduler.cuts_learning(); },
                          [&] { return scheduler.cuts_pass(); }};
    const RenderJob plain = unlearned(job);
    std::optional<PassMaker> passes(std::in_place, job, result, asked);
    for (PassRange interval = scheduler.next_interval(); interval.size() > 0;
         interval = scheduler.next_interval()) {
        const auto number = static_cast<std::uint32_t>(interval.begin);
        auto radius_factor = passes->make(number, result.film);
        if (!radius_factor && result.film.pass_count() == 0) {
            passes.emplace(plain, result, asked);
            result.film = Film(key_of(plain));
            result.is_unlearned = true;
            radius_factor = passes->make(number, result.film);
        }
        if (!radius_factor) break;
        result.radius_factor = *radius_factor;
        scheduler.reached_target(interval.end);
        scheduler.interval_ended(0, false);
    }
    scheduler.finish();
    return result;
}

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
            if (over) return;  // one machine would not have rendered it
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
    RenderResult begin = begin_of(job, std::move(earlier));
    if (ranks.is_alone()) return render_alone(job, hooks, std::move(begin));
    check_shareable(job.settings, ranks);
    return render_among(ranks, job, hooks, std::move(begin));
}

}  // namespace sunfleck::engine
