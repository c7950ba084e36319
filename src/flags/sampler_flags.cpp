// The rows of the flags of single samplers.
#include "flags/flag_tables.h"

namespace sunfleck::engine {
namespace {

/// Another part of the sampler, without which this one does nothing.
FlagNeed needs_part(const std::string& flag, const std::string& name) {
    return {.flag = flag, .values = {"auto"}, .why = "is a part of " + name + ", which is off"};
}

/// A part that is there, unless it is switched off.
FlagValue auto_or_off(bool PhotonSettings::*is_on, const char* if_auto, const char* if_off) {
    return one_of({{"auto", if_auto}, {"off", if_off}}, [=](RenderRequest& r, const auto& name) {
        r.settings.photon.*is_on = name == "auto";
    });
}

}  // namespace

std::vector<RenderFlag> adaptive_flags() {
    using P = PhotonSettings;
    return {
        {.name = "--splitting",
         .value = auto_or_off(&P::splitting, "where these are rare", "one level, as in the paper"),
         .help = "Multilevel splitting towards visible paths"},
        {.name = "--emission-guide",
         .value = auto_or_off(&P::emission_guide, "where these are rare", "Markov chains alone"),
         .help = "Learns where on the lights visible paths start"},
        {.name = "--guide-search",
         .value = auto_or_off(&P::guide_search, "where chains find no light", "chains alone"),
         .help = "Importons and edges look for light, for the emission guide",
         .needs = {needs_part("--emission-guide", "the emission guide")}},
        {.name = "--light-strata",
         .value = auto_or_off(&P::light_strata, "where visible fractions of lights are unlike",
                              "all lights together"),
         .help = "Lights are sampled as strata"},
        {.name = "--adaptive-pixels",
         .value =
             auto_or_off(&P::adaptive_pixels, "where the measured noise is high", "one per pixel"),
         .help = "Up to 64 camera paths per pass in a pixel"},
    };
}

std::vector<RenderFlag> paper_flags() {
    return {
        {.name = "--replica-exchange",
         .value = one_of({{"on"}, {"off", "a plain chain; all uniform paths only count"}},
                         [](auto& r, const auto& name) {
                             r.settings.photon.paper.replica_exchange = name == "on";
                         }),
         .help = "Uniform paths may replace the state of the chain"},
        {.name = "--mutation-size",
         .value = value_of(
             "adaptive|THETA",
             [](const std::string& text, const std::string& flag) -> std::optional<double> {
                 if (text == "adaptive") return {};
                 return read_positive(text, flag, 1000);
             },
             [](auto& r, const auto& theta) { r.settings.photon.paper.mutation_size = theta; }),
         .help = "Size of mutations: as adapted while rendering, or theta of the paper's "
                 "equation 9",
         .default_value = "adaptive"},
        {.name = "--target-acceptance",
         .value = value_of(
             "X",
             [](const std::string& text, const std::string& flag) {
                 return read_positive(text, flag, 1);
             },
             [](auto& r, const auto& share) { r.settings.photon.paper.target_acceptance = share; }),
         .help = "Fraction of mutations to accept",
         .default_value = "0.234",
         .needs = {{.flag = "--mutation-size",
                    .values = {"adaptive"},
                    .why = "has no meaning with a fixed --mutation-size",
                    .mend = "leave one of them out"}}},
    };
}

}  // namespace sunfleck::engine
