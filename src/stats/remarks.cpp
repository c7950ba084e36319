// Remarks from the scene, the film, and what the render had to leave out.
#include "stats/remarks.h"

#include "core/duration_text.h"
#include "core/processor.h"
#include "planning/missing_light.h"
#include "render/count_pass.h"
#include "stats/darkness.h"
#include "stats/image_stats.h"
#include "stats/stats.h"

#include <fmt/format.h>

namespace sunfleck::engine {

std::vector<std::string> machine_warnings(const std::string& isa) {
    if (isa != "avx2" || cpu_has_avx2()) return {};
    return {"this machine has no AVX2: bytes may differ from those of other machines"};
}

std::vector<std::string> remarks_before(const RenderJob& job, const std::string& isa) {
    std::vector<std::string> remarks = machine_warnings(isa);
    for (const auto& entry : job.scene.warnings().entries()) remarks.push_back(entry.line());
    if (job.settings.photon.sampler == PhotonSampler::paper)
        remarks.emplace_back(
            "sampler paper: its statistics are pooled over passes whose visible points and radii "
            "differ, so the picture is biased at finite time and has no error bars; the sampler "
            "adaptive has them");
    return remarks;
}

std::vector<std::string> remarks_after(const RenderJob& job, const RenderResult& result) {
    std::vector<std::string> remarks =
        extrapolation_warnings(result.film, job.stop.error_terms.extrapolated);
    const auto add = [&](const std::vector<std::string>& lines) {
        remarks.insert(remarks.end(), lines.begin(), lines.end());
    };
    if (result.is_unlearned)
        add(
            {fmt::format("--time {} is too short for the pilots of --photon-sampler adaptive: "
                         "the picture is noisier, as with uniform; give it more time",
                         duration_text(*job.stop.seconds))});
    // The scene's warnings say already that a scene without lights is black.
    if (job.scene.is_dark()) return remarks;
    add(darkness_warnings(result.film, [&] {
        RenderSettings settings = job.settings;
        settings.transport.indirect = indirect_of(result.film);
        return share_lit_by_photons(job.scene, settings);
    }));
    add(reliability_warnings(result.film));
    return remarks;
}

}  // namespace sunfleck::engine
