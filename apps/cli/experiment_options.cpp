// Reading the flags of `sunfleck experiment`.
#include "apps/cli/experiment_options.h"

#include "apps/cli/flag_rows.h"
#include "core/error.h"

namespace sunfleck {
namespace {

OtherPicture read_other(const std::string& text, const std::string& flag) {
    const std::size_t first = text.find('=');
    const std::size_t second = first == std::string::npos ? first : text.find('=', first + 1);
    if (second == std::string::npos || first == 0 || second == first + 1 ||
        second + 1 == text.size())
        throw Error({flag}, "\"" + text + "\" is no SCENE=LABEL=FILE",
                    "write for instance room=pbrt=room-pbrt.exr");
    return {text.substr(0, first), text.substr(first + 1, second - first - 1),
            text.substr(second + 1)};
}

/// Minutes, or a time with its unit.
double read_minutes(const std::string& text, const std::string& flag) {
    const bool plain = text.find_first_not_of("0123456789.") == std::string::npos;
    return read_duration(plain ? text + "m" : text, flag);
}

}  // namespace

void add_experiment_flags(CLI::App& app, ExperimentOptions& o) {
    RunSettings& run = o.run;
    app.add_option("NAMES", o.names,
                   "Figures: table1, fig1, fig5 to fig13, or all; none: list them")
        ->type_name("NAME");
    app.add_option("-o,--output", run.folder,
                   "Folder of the run; one begun before goes on (default experiment)")
        ->type_name("FOLDER");
    add_value(app, "--minutes", "N", run.cpu_seconds, read_minutes,
              "Processor minutes of each render, of all threads together; or 30s, 2h "
              "(default 1)");
    add_value(app, "--passes", "N", run.passes, whole_from(1, 1 << 20),
              "Passes of each render, instead of minutes");
    add_value(app, "--seeds", "N", run.seeds, whole_from(1, 1000),
              "Renders of each method (default 5)");
    add_value(app, "--scale", "X", run.scale, number_from(0.02, 1),
              "Sides of pictures, of full size (0.02 to 1; default 1)");
    add_value(app, "--reference-budget", "X", run.reference_budget, number_from(1, 1e4),
              "Length of references, in renders (default 10)");
    add_value(app, "--nthreads", "N", run.threads, whole_from(1, 4096),
              "Threads (1 to 4096; default all)");
    add_values(app, "--other", "SCENE=LABEL=FILE", run.others, read_other,
               "Another renderer's picture, shown and measured; may be repeated");
}

void check_experiment(const CLI::App& given) {
    if (given.count("--minutes") > 0 && given.count("--passes") > 0)
        throw Error({"--minutes"}, "given together with --passes", "give one");
}

}  // namespace sunfleck
