// Reading the flags of `sunfleck experiment`.
#include "apps/cli/experiment_options.h"

#include "apps/cli/number_check.h"
#include "apps/cli/values.h"
#include "sunfleck/error.h"

#include <CLI/CLI.hpp>

namespace sunfleck::engine {
namespace {

OtherPicture read_other(const std::string& text) {
    const std::size_t first = text.find('=');
    const std::size_t second = first == std::string::npos ? first : text.find('=', first + 1);
    if (second == std::string::npos || first == 0 || second == first + 1 ||
        second + 1 == text.size())
        throw Error({"--other"}, "\"" + text + "\" is no SCENE=LABEL=FILE",
                    "write for instance room=pbrt=room-pbrt.exr");
    return {text.substr(0, first), text.substr(first + 1, second - first - 1),
            text.substr(second + 1)};
}

}  // namespace

void add_experiment_flags(CLI::App& app, ExperimentOptions& o, ExperimentTexts& t) {
    app.add_option("NAMES", o.names,
                   "Figures: table1, fig1, fig5 to fig13, or all; none: list them");
    app.add_option("-o,--output", o.run.folder, "Folder of the run; one begun before goes on")
        ->capture_default_str();
    app.add_option(
        "--minutes", t.minutes,
        "Processor minutes of each render, of all threads together (default 1); or 30s, 2h");
    app.add_option("--passes", o.run.passes, "Passes of each render, instead of minutes")
        ->check(whole(1, 1 << 20));
    app.add_option("--seeds", o.run.seeds, "Renders of each method (default 5)")
        ->check(whole(1, 1000));
    app.add_option("--scale", o.run.scale, "Sides of pictures, of full size (default 1)")
        ->check(between(0.02, 1));
    app.add_option("--reference-budget", o.run.reference_budget,
                   "Length of references, in renders (default 10)")
        ->check(between(1, 1e4));
    app.add_option("--nthreads", o.run.threads, "Threads (default: all)")->check(whole(1, 4096));
    app.add_option("--other", t.others,
                   "SCENE=LABEL=FILE: another renderer's picture, shown and measured; may be "
                   "repeated")
        ->allow_extra_args(false);
}

void finish_experiment(const ExperimentTexts& t, ExperimentOptions& o) {
    if (!t.minutes.empty()) {
        if (o.run.passes > 0)
            throw Error({"--minutes"}, "given together with --passes", "give one");
        const bool plain = t.minutes.find_first_not_of("0123456789.") == std::string::npos;
        o.run.cpu_seconds = read_duration(plain ? t.minutes + "m" : t.minutes, "--minutes");
    }
    for (const std::string& other : t.others) o.run.others.push_back(read_other(other));
}

}  // namespace sunfleck::engine
