// `sunfleck experiment`: the paper's figures and tables, made again.
#include "apps/cli/commands.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/messages.h"
#include "apps/cli/progress.h"
#include "core/parallel.h"
#include "experiment/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace sunfleck::engine {
namespace {

constexpr InterruptAnswer kExperimentAnswer{
    .first = "ending the render that runs; once more: quit at once",
    .lost = "quit: the render that ran is lost"};

std::vector<Figure> chosen(const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), "all") != names.end()) return figures();
    std::vector<Figure> some;
    for (const Figure& figure : figures())
        if (std::find(names.begin(), names.end(), figure.name) != names.end())
            some.push_back(figure);
    for (const std::string& name : names) figure_named(name);
    return some;
}

void say_progress(const RunProgress& p) {
    const std::string left = p.cpu_seconds_left > 0 ? ", " + duration_text(p.cpu_seconds_left) +
                                                          " of processor time left"
                                                    : "";
    const std::string line =
        p.cell.empty() ? fmt::format("{} renders, {} of them done{}\n", p.of, p.done, left)
                       : fmt::format("[{}/{}] {}{}\n", p.done + 1, p.of, p.cell, left);
    std::fputs(line.c_str(), stdout);  // a line that is lost is no reason to end
    std::fflush(stdout);
}

}  // namespace

int run_experiment(const ExperimentOptions& options) {
    if (options.names.empty()) {
        for (const Figure& figure : figures()) fmt::print("{:<8} {}\n", figure.name, figure.title);
        return 0;
    }
    const std::vector<Figure> wanted = chosen(options.names);
    const ThreadLimit limit(options.run.threads);
    RunSettings settings = options.run;
    settings.program = std::filesystem::read_symlink("/proc/self/exe").string();
    const CellStore store(settings);
    const InterruptGuard guard(kExperimentAnswer);
    try {
        run_figures(store, wanted, &InterruptGuard::interrupted(), say_progress);
    } catch (const Interrupted&) {
        say("interrupted: what is finished is kept; the same command goes on");
        return 130;
    }
    fmt::print("{}/index.html\n", settings.folder);
    return 0;
}

}  // namespace sunfleck::engine
