// Reading the flags of the sampler `adaptive`, and refusing them where they say nothing.
#include "apps/cli/adaptive_options.h"

#include "core/error.h"

#include <CLI/CLI.hpp>

namespace sunfleck {

void add_adaptive_flags(CLI::App& app, AdaptiveTexts& texts) {
    const auto add = [&](const char* flag, std::string& text, const char* what) {
        app.add_option(flag, text, what)->check(CLI::IsMember({"auto", "off"}));
    };
    add("--light-groups", texts.light_groups,
        "Sampler adaptive: auto: lights of which much and little is seen get photon paths apart; "
        "off: all lights together");
    add("--emission-maps", texts.emission_maps,
        "Sampler adaptive: auto: where few paths are seen, learn from where light must start; "
        "off: chains alone");
    add("--noisy-pixels", texts.noisy_pixels,
        "Sampler adaptive: auto: up to 64 camera paths a draw in pixels that are measured to be "
        "noisier than others; off: one in each");
    add("--balance", texts.balance,
        "Sampler adaptive: auto: from pass 16 on as many photon paths a pass as pay beside its "
        "camera paths, measured; off: as many in all passes");
}

void finish_adaptive(const CLI::App& given, const AdaptiveTexts& texts, PhotonSettings& photon) {
    for (const char* flag : {"--light-groups", "--emission-maps", "--noisy-pixels", "--balance"})
        if (given.count(flag) > 0 && photon.sampler != PhotonSampler::adaptive)
            throw Error({flag}, "has a meaning with the sampler adaptive alone", "leave it out");
    if (given.count("--balance") > 0 && given.count("--photons-per-pass") > 0)
        throw Error({"--balance"}, "given together with --photons-per-pass, which is a number",
                    "give one");
    photon.emission_maps = texts.emission_maps == "auto";
    photon.noisy_pixels = texts.noisy_pixels == "auto";
    photon.light_groups = texts.light_groups == "auto";
    photon.balance = texts.balance == "auto";
}

}  // namespace sunfleck
