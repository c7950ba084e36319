// The flags of `sunfleck experiment`.
#pragma once

#include "apps/cli/options.h"

namespace CLI {
class App;
}

namespace sunfleck::engine {

/// Flags whose text needs a reader of its own.
struct ExperimentTexts {
    std::string minutes;
    std::vector<std::string> others;
};

void add_experiment_flags(CLI::App& app, ExperimentOptions& options, ExperimentTexts& texts);

/// To be called when all flags have been read. @throws Error naming a flag that cannot be used.
void finish_experiment(const ExperimentTexts& texts, ExperimentOptions& options);

}  // namespace sunfleck::engine
