// The flags of `sunfleck experiment`.
#pragma once

#include "apps/cli/options.h"

namespace CLI {
class App;
}

namespace sunfleck {

void add_experiment_flags(CLI::App& app, ExperimentOptions& options);

/// @throws Error for flags that do not go together.
void check_experiment(const CLI::App& given);

}  // namespace sunfleck
