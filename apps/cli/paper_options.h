// The flags of the sampler `paper`: what its authors' experiments vary.
#pragma once

#include "apps/cli/options.h"

namespace CLI {
class App;
}

namespace sunfleck::engine {

/// Flags whose text needs a reader of its own.
struct PaperTexts {
    std::string mode;
    std::string replica_exchange = "on";
    std::string mutation_size = "adaptive";
    std::string target_acceptance;
};

void add_paper_flags(CLI::App& app, PaperTexts& texts);

/// Reads the texts; makes --mode paper the sampler, and the sampler the whole mode: direct light by
/// photons, alpha 0.7. To be called when all other flags have been read.
/// @throws Error naming a flag that does not go with the sampler, whichever it is.
void finish_paper(const CLI::App& given, const PaperTexts& texts, RenderOptions& options);

}  // namespace sunfleck::engine
