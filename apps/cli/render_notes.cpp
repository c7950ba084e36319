// Lines about a render: warnings, defaults taken, doubts of its picture.
#include "apps/cli/render_notes.h"

#include "apps/cli/darkness.h"
#include "apps/cli/image_stats.h"
#include "apps/cli/progress_text.h"
#include "apps/cli/stats.h"
#include "core/processor.h"
#include "planning/missing_light.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sunfleck::engine {

std::vector<std::string> machine_warnings(const std::string& isa) {
    if (isa != "avx2" || cpu_has_avx2()) return {};
    return {"this machine has no AVX2: bytes may differ from those of other machines"};
}

std::vector<std::string> warnings_of(const RenderOptions& options, const Scene& scene) {
    std::vector<std::string> lines = machine_warnings(options.request.isa);
    for (const auto& entry : scene.warnings().entries()) lines.push_back(entry.line());
    if (options.request.settings.photon.sampler == PhotonSampler::paper)
        lines.emplace_back(
            "sampler paper: its counts are pooled while the view and the radii change, so the "
            "picture is biased until it has converged, and has no error bars; adaptive is not");
    return lines;
}

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

std::vector<std::string> doubts_of(const RenderSetup& setup, const RenderResult& result) {
    const StopSettings& stop = setup.options.request.stop;
    std::vector<std::string> doubts =
        extrapolation_warnings(result.film, stop.error_terms.extrapolated);
    const auto add = [&](const std::vector<std::string>& lines) {
        doubts.insert(doubts.end(), lines.begin(), lines.end());
    };
    if (result.is_unlearned)
        add({fmt::format(
            "--time {} is too short to learn where photons are needed and to use it: the picture "
            "is that of --photon-sampler uniform, noisier; give it more time",
            duration_text(*stop.seconds))});
    // A dark scene has a black picture for sure, and that has been said.
    if (setup.scene.is_dark()) return doubts;
    add(darkness_warnings(result.film,
                          [&] { return share_lit_by_photons(setup.scene, setup.job.settings); }));
    add(reliability_warnings(result.film));
    return doubts;
}

}  // namespace sunfleck::engine
