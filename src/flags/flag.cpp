// What rows of flags have in common: a condition, and the help that is put together from a row.
#include "flags/flag.h"

#include "photon_samplers/samplers.h"

namespace sunfleck::engine {

FlagNeed refused_by_paper(const std::string& why, const std::string& mend) {
    std::vector<std::string> others;
    for (const PhotonSamplerRow& row : kPhotonSamplers)
        if (row.sampler != PhotonSampler::paper) others.emplace_back(row.name);
    return {.flag = "--photon-sampler", .values = others, .why = why, .mend = mend};
}

std::string help_text(const RenderFlag& flag) {
    std::string text = flag.help;
    const char* before = flag.value.is_list ? ": " : ". ";
    for (const FlagChoice& choice : flag.value.choices) {
        if (choice.what.empty() && !flag.value.is_list) continue;
        text += before + choice.name + (choice.what.empty() ? "" : ": " + choice.what);
        before = flag.value.is_list ? "," : "; ";
    }
    const std::string range = flag.value.range;
    const std::string standard = flag.default_value.empty() ? "" : "default " + flag.default_value;
    if (range.empty() && standard.empty()) return text;
    return text + " (" + range + (range.empty() || standard.empty() ? "" : "; ") + standard + ")";
}

}  // namespace sunfleck::engine
