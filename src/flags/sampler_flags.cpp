// The rows of the flags of single samplers.
#include "flags/sampler_flags.h"

namespace sunfleck {
namespace {

/// Only the sampler `adaptive` or only the sampler `paper` has a use for the flag.
FlagNeed needs_sampler(const std::string& name, const std::string& mend) {
    return {.flag = "--photon-sampler",
            .values = {name},
            .why = "has a meaning with the sampler " + name + " alone",
            .mend = mend};
}

}  // namespace

std::vector<RenderFlag> adaptive_flags() {
    std::vector<RenderFlag> rows;
    for (const AdaptivePart& part : kAdaptiveParts) {
        RenderFlag row{
            .name = "--" + std::string(part.name),
            .group = "Parts of the sampler adaptive",
            .value = one_of({{"auto"}, {"off"}},
                            [&part](RenderRequest& r, const std::string& name) {
                                r.settings.photon.*part.is_on = name == "auto";
                            }),
            .help = std::string(part.what),
            .standard = "auto",
            .needs = {needs_photon_mapping(), needs_sampler("adaptive", "leave it out")}};
        const auto is_part_of = [&](const char* flag, const char* name) {
            row.needs.push_back(
                {.flag = flag,
                 .values = {"auto"},
                 .why = std::string("is a part of the ") + name + ", which is off"});
        };
        if (part.is_on == &PhotonSettings::guide_search)
            is_part_of("--emission-guide", "emission guide");
        if (part.is_on == &PhotonSettings::pass_weights)
            is_part_of("--photon-budget", "photon budget");
        if (part.is_on == &PhotonSettings::pass_weights ||
            part.is_on == &PhotonSettings::photon_budget)
            row.needs.push_back({.flag = "--photons-per-pass",
                                 .why = "given together with --photons-per-pass, which is a number",
                                 .mend = "give one"});
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<RenderFlag> paper_flags() {
    const char* const group = "Parts of the sampler paper";
    const FlagNeed paper = needs_sampler("paper", "leave it out, or add --mode paper");
    return {
        {.name = "--replica-exchange",
         .group = group,
         .value = one_of({{"on"}, {"off", "a plain chain; all uniform paths only count"}},
                         [](RenderRequest& r, const std::string& name) {
                             r.settings.photon.paper.replica_exchange = name == "on";
                         }),
         .help = "Uniform paths may replace the state of the chain",
         .standard = "on",
         .needs = {needs_photon_mapping(), paper}},
        {.name = "--mutation-size",
         .group = group,
         .value = value_of(
             "adaptive|THETA",
             [](const std::string& text, const std::string& flag) -> std::optional<double> {
                 if (text == "adaptive") return {};
                 return read_positive(text, flag, 1000);
             },
             [](RenderRequest& r, std::optional<double> theta) {
                 r.settings.photon.paper.mutation_size = theta;
             }),
         .help = "Size of mutations: as adapted while rendering, or theta of the paper's "
                 "equation 9",
         .standard = "adaptive",
         .needs = {needs_photon_mapping(), paper}},
        {.name = "--target-acceptance",
         .group = group,
         .value = value_of(
             "X",
             [](const std::string& text, const std::string& flag) {
                 return read_positive(text, flag, 1);
             },
             [](RenderRequest& r, double share) {
                 r.settings.photon.paper.target_acceptance = share;
             }),
         .help = "Fraction of mutations to accept",
         .standard = "0.234",
         .needs = {needs_photon_mapping(),
                   paper,
                   {.flag = "--mutation-size",
                    .values = {"adaptive"},
                    .why = "has no meaning with a fixed --mutation-size",
                    .mend = "leave one of them out"}}},
    };
}

}  // namespace sunfleck
