// The flags of `sunfleck render`.
#pragma once

#include "apps/cli/adaptive_options.h"
#include "apps/cli/error_options.h"
#include "apps/cli/options.h"
#include "apps/cli/paper_options.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace sunfleck::engine {

/// Flags whose text needs a reader of its own.
struct RenderTexts {
    std::string time;
    std::string cpu_time;
    std::string memory_limit;
    std::string every;
    std::string target_error;
    std::string resolution;
    std::string crop;
    std::string crop_window;
    std::string pass_range;
    std::string aovs;
    std::vector<std::string> light_groups;
    std::string sampler = "adaptive";
    AdaptiveTexts adaptive;
    PaperTexts paper;
    ErrorTexts error;
    std::string direct = "sampled";
    std::string ris = "auto";
    std::string energy_compensation = "off";
    std::string integrator = "sppm";
    std::string seed;
    std::string log_level;
    bool quiet = false;
    std::optional<std::uint32_t> passes;
};

void add_render_flags(CLI::App& app, RenderOptions& options, RenderTexts& texts);

/// To be called when all flags have been read. @throws Error naming a flag that cannot be used.
void finish_render(const CLI::App& given, const RenderTexts& texts, RenderOptions& options);

}  // namespace sunfleck::engine
