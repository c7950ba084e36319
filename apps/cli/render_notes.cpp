// Depth, ends and outputs, where they were not given.
#include "apps/cli/render_notes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sunfleck::engine {

std::vector<std::string> notes_of(const RenderSetup& setup) {
    const RenderOptions& options = setup.options;
    std::vector<std::string> lines;
    if (!options.request.max_depth && !setup.scene.hints().max_depth)
        lines.push_back(fmt::format("maximum depth not given; using {} (--max-depth)",
                                    setup.job.settings.transport.max_depth));
    if (options.request.ends_by_default)
        lines.emplace_back(setup.job.stop.target_error
                               ? "no limit given; ending at an error of 2% or after 10 minutes "
                                 "(--target-error, --time)"
                               : "no limit given; ending after 10 minutes (--time)");
    if (options.outputs.empty())
        lines.push_back(
            fmt::format("no output given; writing {} (-o)", fmt::join(setup.outputs, " ")));
    return lines;
}

}  // namespace sunfleck::engine
