// Reading the flags of the sampler `adaptive`, and refusing them where they say nothing.
#include "apps/cli/adaptive_options.h"

#include "sunfleck/error.h"

#include <CLI/CLI.hpp>

namespace sunfleck::engine {

std::string flag_of(const AdaptivePart& part) {
    return "--" + std::string(part.name);
}

void add_adaptive_flags(CLI::App& app, AdaptiveTexts& texts) {
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const AdaptivePart& part = kAdaptiveParts.at(i);
        app.add_option(flag_of(part), texts.at(i), "Sampler adaptive: " + std::string(part.what))
            ->check(CLI::IsMember({"auto", "off"}));
    }
}

void finish_adaptive(const CLI::App& given, const AdaptiveTexts& texts, PhotonSettings& photon) {
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const AdaptivePart& part = kAdaptiveParts.at(i);
        const std::string flag = flag_of(part);
        if (given.count(flag) > 0 && photon.sampler != PhotonSampler::adaptive)
            throw Error({flag}, "has a meaning with the sampler adaptive alone", "leave it out");
        photon.*part.is_on = texts.at(i) != "off";
    }
    if (given.count("--guide-search") > 0 && !photon.emission_guide)
        throw Error({"--guide-search"}, "is a part of the emission guide, which is off",
                    "leave it out");
    if (given.count("--pass-weights") > 0 && !photon.photon_budget)
        throw Error({"--pass-weights"}, "is a part of the photon budget, which is off",
                    "leave it out");
    for (const char* flag : {"--photon-budget", "--pass-weights"})
        if (given.count(flag) > 0 && given.count("--photons-per-pass") > 0)
            throw Error({flag}, "given together with --photons-per-pass, which is a number",
                        "give one");
}

}  // namespace sunfleck::engine
