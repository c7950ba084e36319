// Reading the flags about bias, and refusing them where there is none to know.
#include "apps/cli/error_options.h"

#include "sunfleck/error.h"

#include <CLI/CLI.hpp>

namespace sunfleck::engine {

void add_extrapolate_flag(CLI::App& app, ErrorTexts& texts) {
    app.add_option("--extrapolate", texts.extrapolate,
                   "on: subtract the bias of the photons' discs, as it shows in how light falls "
                   "with their radius. Pictures have 2 to 3.5 times the noise")
        ->check(CLI::IsMember({"on", "off"}));
}

void add_error_flags(CLI::App& app, ErrorTexts& texts) {
    add_extrapolate_flag(app, texts);
    app.add_option("--target-error-of", texts.target_error_of,
                   "What --target-error is about: all (noise, and the bias of the photons' discs), "
                   "or noise")
        ->check(CLI::IsMember({"all", "noise"}));
}

void finish_error(const CLI::App& given, const ErrorTexts& texts, RenderOptions& options) {
    const bool has_discs = options.settings.integrator == Integrator::sppm;
    const bool is_paper = options.settings.photon.sampler == PhotonSampler::paper;
    for (const char* flag : {"--extrapolate", "--target-error-of"}) {
        if (given.count(flag) == 0) continue;
        if (!has_discs)
            throw Error({flag},
                        "is about the discs of photon mapping, and this integrator has none",
                        "leave it out");
        if (is_paper)
            throw Error({flag}, "needs passes that do not build on one another",
                        "leave it out, or use another sampler than paper");
    }
    options.stop.error_terms = {texts.target_error_of == "all", texts.extrapolate == "on"};
}

}  // namespace sunfleck::engine
