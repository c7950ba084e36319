// `sunfleck merge`: pass ranges of one render, added up exactly.
#include "apps/cli/commands.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/picture_flags.h"
#include "core/thread_trial.h"
#include "film/film_file.h"
#include "film/film_picture.h"
#include "image/atomic_file.h"
#include "stats/darkness.h"
#include "stats/image_stats.h"
#include "stats/stats.h"
#include "sunfleck/error.h"

namespace sunfleck::engine {

int run_merge(const MergeOptions& options) {
    try_threads();
    check_outputs(options.outputs, {options.stats});
    std::vector<std::string> written = options.outputs;
    written.push_back(options.stats);
    check_apart({options.inputs, written});
    const OutputClaims claims(written);
    Film film = read_film(options.inputs.front());
    for (std::size_t i = 1; i < options.inputs.size(); ++i)
        film.merge(read_film(options.inputs[i]), options.inputs[i]);
    if (options.extrapolate && !film.key().has_discs())
        throw Error({"--extrapolate"},
                    options.inputs.front() +
                        " was not rendered by photon mapping, and has no bias to remove",
                    "leave it out");
    if (!options.files.exr.half_layers.empty())
        check_half_layers(options.files.exr, film_picture(film, {options.extrapolate}));
    DeferredError faults(LogLevel::quiet);  // thrown when all is tried
    write_outputs(options.outputs, film, {options.exposure, options.extrapolate, options.files},
                  faults);
    const auto doubts = extrapolation_warnings(film, options.extrapolate);
    for (const std::string& line : doubts) say(line);
    if (!options.stats.empty()) {
        RunFacts facts;
        facts.command = "merge";
        facts.error_terms.extrapolated = options.extrapolate;
        facts.warnings = darkness_warnings(film);
        const auto others = reliability_warnings(film);
        facts.warnings.insert(facts.warnings.end(), others.begin(), others.end());
        facts.warnings.insert(facts.warnings.end(), doubts.begin(), doubts.end());
        const std::string json = stats_json(film, facts);
        faults.attempt([&] { write_file(options.stats, json); });
    }
    faults.finish();
    return 0;
}

}  // namespace sunfleck::engine
