// `sunfleck experiment`: the paper's figures and tables, made again.
#include "apps/cli/commands.h"
#include "apps/cli/interrupt.h"
#include "apps/cli/progress.h"
#include "core/parallel.h"
#include "experiment/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace sunfleck {
namespace {

std::vector<Figure> chosen(const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), "all") != names.end()) return figures();
    std::vector<Figure> some;
    for (const Figure& figure : figures())
        if (std::find(names.begin(), names.end(), figure.name) != names.end())
            some.push_back(figure);
    for (const std::string& name : names) figure_named(name);
    return some;
}

void say(const RunProgress& p) {
    const std::string left = p.cpu_seconds_left > 0 ? ", " + duration_text(p.cpu_seconds_left) +
                                                          " of processor time left"
                                                    : "";
    if (p.cell.empty())
        fmt::print("{} renders, {} of them done{}\n", p.of, p.done, left);
    else
        fmt::print("[{}/{}] {}{}\n", p.done + 1, p.of, p.cell, left);
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
    const InterruptGuard guard;
    try {
        run_figures(store, wanted, &InterruptGuard::interrupted(), say);
    } catch (const Interrupted&) {
        fmt::print(stderr, "interrupted: what is finished is kept; the same command goes on\n");
        return 130;
    }
    fmt::print("{}/index.html\n", settings.folder);
    return 0;
}

}  // namespace sunfleck
