// Reading the paper's flags, and refusing what cannot go together.
#include "apps/cli/paper_options.h"

#include "apps/cli/values.h"
#include "sunfleck/error.h"

#include <CLI/CLI.hpp>

namespace sunfleck::engine {
namespace {

void refuse(const CLI::App& given, const char* flag, const std::string& why,
            const std::string& mend) {
    if (given.count(flag) > 0) throw Error({flag}, why, mend);
}

}  // namespace

void add_paper_flags(CLI::App& app, PaperTexts& texts) {
    app.add_option("--mode", texts.mode,
                   "paper: the sampler paper, the same as --photon-sampler paper")
        ->check(CLI::IsMember({"paper"}));
    app.add_option("--replica-exchange", texts.replica_exchange,
                   "Sampler paper: on, or off (a plain chain; all uniform paths only count)")
        ->check(CLI::IsMember({"on", "off"}));
    app.add_option("--mutation-size", texts.mutation_size,
                   "Sampler paper: adaptive, or theta of its equation 9");
    app.add_option("--target-acceptance", texts.target_acceptance,
                   "Sampler paper: share of mutations to accept (default 0.234)");
}

void finish_paper(const CLI::App& given, const PaperTexts& texts, RenderOptions& options) {
    PhotonSettings& photon = options.settings.photon;
    const bool mode = given.count("--mode") > 0;
    if (mode && photon.sampler != PhotonSampler::paper)
        refuse(given, "--photon-sampler", "is paper with --mode paper", "leave it out");
    if (mode) photon.sampler = PhotonSampler::paper;
    if (photon.sampler != PhotonSampler::paper) {
        for (const char* flag : {"--replica-exchange", "--mutation-size", "--target-acceptance"})
            refuse(given, flag, "has a meaning with the sampler paper alone",
                   "leave it out, or add --mode paper");
        return;
    }
    refuse(given, "--pass-range", "passes of the sampler paper build on those before",
           "use --passes");
    refuse(given, "--target-error", "the sampler paper has no error bars",
           "use --passes or --time");
    options.stop.target_error.reset();
    if (options.settings.transport.direct == DirectLight::sampled)
        refuse(given, "--direct", "is photons with the sampler paper", "leave it out");
    refuse(given, "--indirect-radius", "is 1 with the sampler paper", "leave it out");
    const double alpha = options.settings.alpha;
    use_paper_mode(options.settings);
    if (given.count("--alpha") > 0) options.settings.alpha = alpha;
    photon.paper.replica_exchange = texts.replica_exchange == "on";
    if (texts.mutation_size != "adaptive") {
        photon.paper.mutation_size = read_positive(texts.mutation_size, "--mutation-size", 1000);
        refuse(given, "--target-acceptance", "has no meaning with a fixed --mutation-size",
               "leave one of them out");
    }
    if (!texts.target_acceptance.empty())
        photon.paper.target_acceptance =
            read_positive(texts.target_acceptance, "--target-acceptance", 1);
}

}  // namespace sunfleck::engine
