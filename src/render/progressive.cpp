// The loop over passes, and when it ends.
#include "render/progressive.h"

#include "core/stopwatch.h"
#include "film/error_bars.h"
#include "render/paper.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sunfleck {
namespace {

bool is_paper(const RenderSettings& settings) {
    return settings.integrator == Integrator::sppm &&
           settings.photon.sampler == PhotonSampler::paper;
}

/// Photon paths; camera paths of the path tracer.
double paths_of(const PassResult& pass, Integrator integrator) {
    if (integrator == Integrator::path) return static_cast<double>(pass.image.pixels());
    return static_cast<double>(pass.statistics[Count::uniform_paths] +
                               pass.statistics[Count::mutated_paths]);
}

FilmKey key_of(const RenderJob& job) {
    const PixelWindow window = window_of(job.scene.film());
    const Vec2i whole = job.scene.film().resolution;
    FilmKey key{window.width(),    window.height(), job.settings.layers,
                job.settings.seed, job.scene_hash,  job.settings.text()};
    key.settings += "resolution=" + std::to_string(whole.x) + "x" + std::to_string(whole.y) +
                    "\nwindow=" + std::to_string(window.x0) + "," + std::to_string(window.y0) +
                    "\n";
    key.sequential = is_paper(job.settings);
    return key;
}

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

void follow(const PassResult& pass, Progress& progress) {
    progress.visible_fraction +=
        (pass.visible_fraction - progress.visible_fraction) / progress.passes;
    if (is_starved(pass)) ++progress.starved;
    progress.levels = pass.ladder.levels.empty() ? 0 : pass.ladder.levels.size() - 1;
    const Acceptance mutations = pass.ladder.mutations();
    progress.acceptance = mutations.proposed == 0 ? 0
                                                  : static_cast<double>(mutations.accepted) /
                                                        static_cast<double>(mutations.proposed);
}

/// The error falls about with the root of the number of passes; the bias of the radius apart.
std::optional<double> seconds_left(const Progress& p, const StopSettings& stop) {
    std::optional<double> left;
    const auto at_most = [&](double seconds) {
        left = std::min(left.value_or(seconds), std::max(0.0, seconds));
    };
    if (p.of) at_most(p.seconds / p.passes * (*p.of - p.passes));
    if (stop.seconds) at_most(*stop.seconds - p.seconds);
    if (p.error && p.target) at_most(p.seconds * (std::pow(*p.error / *p.target, 2) - 1));
    return left;
}

}  // namespace

RenderResult render(const RenderJob& job, const RenderHooks& hooks) {
    const StopSettings& stop = job.stop;
    WorkClock clock;
    RenderResult result{Film(key_of(job)), {}, 0, 0, 1, false};
    Progress progress;
    progress.target = stop.target_error;
    if (stop.end_pass) progress.of = *stop.end_pass - stop.first_pass;
    double paths = 0;
    std::optional<Epoch> epoch;
    std::optional<PaperRender> paper;
    if (is_paper(job.settings)) paper.emplace(job.scene, job.settings);
    for (std::uint32_t number = stop.first_pass; !stop.end_pass || number < *stop.end_pass;
         ++number) {
        if (!paper && (!epoch || epoch->number != epoch_of(number))) {
            epoch = learn_epoch(job.scene, job.settings, number);
            result.seconds.learn += epoch->seconds;
        }
        const PassResult pass =
            paper ? paper->next_pass() : render_pass(job.scene, job.settings, number, *epoch);
        add_pass(result.film, number, pass);
        if (paper) paper->count(result.film);
        result.seconds += pass.seconds;
        result.radius_factor = pass.radius_factor;
        progress.passes = ++result.passes;
        if (pass.statistics[Count::uniform_paths] > 0) follow(pass, progress);
        progress.seconds = clock.seconds();
        paths += paths_of(pass, job.settings.integrator);
        progress.paths_per_second = paths / progress.seconds;
        if ((number + 1) % kRoundPasses == 0) progress.error = target_error(result.film);
        progress.seconds_left = seconds_left(progress, stop);
        if (hooks.report) hooks.report(progress);
        result.interrupted = hooks.interrupted != nullptr && hooks.interrupted->load();
        const bool late = stop.seconds && progress.seconds >= *stop.seconds;
        const bool good = progress.error && progress.target && *progress.error <= *progress.target;
        if (hooks.snapshot && std::has_single_bit(result.passes))
            clock.aside([&] { hooks.snapshot(result); });
        if (result.interrupted || late || good) break;
    }
    result.total_seconds = clock.seconds();
    if (hooks.snapshot && !std::has_single_bit(result.passes)) hooks.snapshot(result);
    return result;
}

}  // namespace sunfleck
