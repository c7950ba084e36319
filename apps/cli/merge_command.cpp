// `sunfleck merge`: pass ranges of one render, added up exactly.
#include "apps/cli/commands.h"
#include "apps/cli/outputs.h"
#include "apps/cli/stats.h"
#include "film/film_file.h"
#include "image/atomic_file.h"

namespace sunfleck {

int run_merge(const MergeOptions& options) {
    check_outputs(options.outputs, options.stats);
    Film film = read_film(options.inputs.front());
    for (std::size_t i = 1; i < options.inputs.size(); ++i)
        film.merge(read_film(options.inputs[i]), options.inputs[i]);
    write_outputs(options.outputs, film, options.exposure);
    if (!options.stats.empty()) {
        RunFacts facts;
        facts.command = "merge";
        facts.warnings = reliability_warnings(film);
        const std::string json = stats_json(film, facts);
        write_file(options.stats, json);
    }
    return 0;
}

}  // namespace sunfleck
